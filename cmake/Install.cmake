# cmake --install, and find_package(turgor) afterwards.
include(CMakePackageConfigHelpers)

install(TARGETS turgor_core turgor_mesh turgor_membrane turgor_case EXPORT turgorTargets)
install(TARGETS turgor RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(TURGOR_SWEEP)
  install(TARGETS turgor-sweep RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
if(TURGOR_FEM)
  install(TARGETS turgor-fem RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(DIRECTORY include/turgor DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.hpp" PATTERN "fem" EXCLUDE PATTERN "figures" EXCLUDE PATTERN "run" EXCLUDE PATTERN "sweep" EXCLUDE
  PATTERN "view" EXCLUDE)
install(FILES ${PROJECT_BINARY_DIR}/include/turgor/base/version.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/turgor/base)
install(FILES docs/turgor.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(DIRECTORY cases DESTINATION ${CMAKE_INSTALL_DATADIR}/turgor)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/turgor)
install(EXPORT turgorTargets NAMESPACE turgor:: DESTINATION ${package_dir})
configure_package_config_file(cmake/turgorConfig.cmake.in ${PROJECT_BINARY_DIR}/turgorConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/turgorConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/turgorConfig.cmake ${PROJECT_BINARY_DIR}/turgorConfigVersion.cmake
  cmake/FindUdunits2.cmake cmake/FindLibcsv.cmake DESTINATION ${package_dir})
