# SIMD kernels: one source, compiled for several instruction sets and put into a target.
#
# Code for AVX must not be reached on machines without it, but the kernels instantiate templates that the rest of the
# program uses too, and a linker keeps any one of several copies. So each kernel is linked by itself first, and every
# symbol of it but its entry is made local.

function(turgor_simd_kernel target prefix source set lanes)
  set(name ${prefix}_${set})
  add_library(${name} OBJECT ${source})
  get_target_property(rarely ${target} EXCLUDE_FROM_ALL)
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON EXCLUDE_FROM_ALL ${rarely})
  target_compile_features(${name} PRIVATE cxx_std_20)
  target_compile_definitions(${name} PRIVATE TURGOR_KERNEL=${name} TURGOR_KERNEL_LANES=${lanes})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_BINARY_DIR}/include
    ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${name} PRIVATE Eigen3::Eigen turgor_warnings)
  if(lanes EQUAL 1)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${name}>)
    return()
  endif()
  # GCC's own AVX-512 intrinsics and the attributes of its vector types set the warnings off. The parameters let it inline
  # the right-hand side into every stage of a step, which is worth 3 %.
  target_compile_options(${name} PRIVATE ${ARGN} -Wno-uninitialized -Wno-maybe-uninitialized -Wno-ignored-attributes
    $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique;--param=max-inline-insns-single=3000;--param=inline-unit-growth=400;--param=large-function-growth=2000>)
  set(local ${CMAKE_CURRENT_BINARY_DIR}/${name}.o)
  add_custom_command(OUTPUT ${local}
    COMMAND ${CMAKE_LINKER} -r --force-group-allocation -o ${local} $<TARGET_OBJECTS:${name}>
    COMMAND ${CMAKE_OBJCOPY} --wildcard --keep-global-symbol=*${name}* ${local}
    DEPENDS ${name} $<TARGET_OBJECTS:${name}> COMMAND_EXPAND_LISTS VERBATIM)
  target_sources(${target} PRIVATE ${local})
  set_source_files_properties(${local} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
  set_property(GLOBAL APPEND PROPERTY TURGOR_ISOLATED_KERNELS ${local})
endfunction()

# Puts PREFIX_scalar and, where the processor may have them, PREFIX_avx2 and PREFIX_avx512 into a target, which learns of
# the latter by TURGOR_SIMD_KERNELS.
function(turgor_simd_kernels target prefix source)
  turgor_simd_kernel(${target} ${prefix} ${source} scalar 1)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    turgor_simd_kernel(${target} ${prefix} ${source} avx2 4 -mavx2 -mfma)
    turgor_simd_kernel(${target} ${prefix} ${source} avx512 8 -mavx512f -mavx512cd -mavx512bw -mavx512dq -mavx512vl
                       -mfma -mprefer-vector-width=512)
    target_compile_definitions(${target} PRIVATE TURGOR_SIMD_KERNELS)
  endif()
endfunction()
