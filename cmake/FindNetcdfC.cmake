# Debian's CMake package of NetCDF names the libraries behind it (curl, OpenSSL, libxml2), whose development files it does
# not bring along. Provides NetcdfC::netcdf.
find_path(NetcdfC_INCLUDE_DIR netcdf.h)
find_library(NetcdfC_LIBRARY netcdf)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(NetcdfC REQUIRED_VARS NetcdfC_LIBRARY NetcdfC_INCLUDE_DIR)
if(NetcdfC_FOUND AND NOT TARGET NetcdfC::netcdf)
  add_library(NetcdfC::netcdf UNKNOWN IMPORTED)
  set_target_properties(NetcdfC::netcdf PROPERTIES
    IMPORTED_LOCATION "${NetcdfC_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${NetcdfC_INCLUDE_DIR}")
endif()
