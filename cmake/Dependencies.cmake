# Finds the libraries that come without one CMake name for all releases of Debian and Ubuntu.
find_package(PkgConfig REQUIRED)
pkg_check_modules(BULLET REQUIRED IMPORTED_TARGET bullet)
pkg_check_modules(OSMESA REQUIRED IMPORTED_TARGET osmesa)
pkg_check_modules(ASSIMP REQUIRED IMPORTED_TARGET assimp)
pkg_check_modules(SQLITE REQUIRED IMPORTED_TARGET sqlite3)
pkg_check_modules(CRYPTO REQUIRED IMPORTED_TARGET libcrypto)
pkg_check_modules(URDFDOM REQUIRED IMPORTED_TARGET urdfdom)

# libsdformat has its major version in its name: 9 is what Ubuntu 20.04 has, 12 what Debian 12 has.
foreach(version 14 13 12 11 10 9)
  find_package(sdformat${version} QUIET)
  if(sdformat${version}_FOUND)
    set(SDFORMAT_LIBRARIES sdformat${version}::sdformat${version})
    set(SDFORMAT_VERSION ${sdformat${version}_VERSION})
    break()
  endif()
endforeach()
if(NOT SDFORMAT_LIBRARIES)
  message(FATAL_ERROR "libsdformat 9 or newer is needed: apt-get install libsdformat-dev")
endif()

pkg_check_modules(ISAL IMPORTED_TARGET libisal)
if(NOT ISAL_FOUND)
  message(FATAL_ERROR "ISA-L is needed: apt-get install libisal-dev")
endif()

# libdeflate has brought a pkg-config file since 1.9 only.
find_path(LIBDEFLATE_INCLUDE_DIR libdeflate.h)
find_library(LIBDEFLATE_LIBRARY deflate)
if(NOT LIBDEFLATE_INCLUDE_DIR OR NOT LIBDEFLATE_LIBRARY)
  message(FATAL_ERROR "libdeflate is needed: apt-get install libdeflate-dev")
endif()

# FreeImage brings neither a CMake nor a pkg-config file.
find_path(FREEIMAGE_INCLUDE_DIR FreeImage.h)
find_library(FREEIMAGE_LIBRARY freeimage)
if(NOT FREEIMAGE_INCLUDE_DIR OR NOT FREEIMAGE_LIBRARY)
  message(FATAL_ERROR "FreeImage is needed: apt-get install libfreeimage-dev")
endif()
