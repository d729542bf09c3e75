# Warnings are errors in every target of this project.
add_library(turgor_warnings INTERFACE)
target_compile_options(turgor_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Wnon-virtual-dtor
  -Woverloaded-virtual -Werror)
# GCC 12 sees an overlap in "text" + string where there is none (its bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(turgor_warnings INTERFACE -Wno-restrict)
endif()
