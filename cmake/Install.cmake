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

# A Debian package by `cpack -G DEB`: see ./dev package.
set(CPACK_PACKAGE_NAME turgor)
set(CPACK_PACKAGE_CONTACT "The Turgor developers <turgor@invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS gnuplot-nox)
if(TURGOR_PYTHON)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS python3-numpy)
  set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-matplotlib, python3-pandas, python3-scipy, python3-tqdm, python3-xarray, python3-netcdf4")
endif()
set(CPACK_STRIP_FILES ON)
include(CPack)
