# Finds the libraries that have no common CMake name across the releases of Debian and Ubuntu.
find_package(PkgConfig REQUIRED)
find_package(ZLIB REQUIRED)
pkg_check_modules(BULLET REQUIRED IMPORTED_TARGET bullet)
pkg_check_modules(ASSIMP REQUIRED IMPORTED_TARGET assimp)
pkg_check_modules(SQLITE REQUIRED IMPORTED_TARGET sqlite3)
pkg_check_modules(LZ4 REQUIRED IMPORTED_TARGET liblz4)
pkg_check_modules(ZSTD REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(CRYPTO REQUIRED IMPORTED_TARGET libcrypto)

# OpenGL on the processor: OSMesa was removed from Mesa 25.1; since Mesa 20, EGL needs no display.
pkg_check_modules(OSMESA IMPORTED_TARGET osmesa)
pkg_check_modules(EGL IMPORTED_TARGET egl)
if(NOT OSMESA_FOUND AND NOT EGL_FOUND)
  message(FATAL_ERROR "OSMesa or EGL is needed: apt-get install libosmesa6-dev, or libegl-dev where there is none")
endif()

# rosdep knows neither ISA-L nor libdeflate, so both are optional.
option(SYNTHETIC_DATASET_QUICK_DEFLATE "Compress PNG files by ISA-L and libdeflate if they are there"
  ON)
pkg_check_modules(ISAL IMPORTED_TARGET libisal)
# libdeflate has a pkg-config file only since 1.9.
find_path(LIBDEFLATE_INCLUDE_DIR libdeflate.h)
find_library(LIBDEFLATE_LIBRARY deflate)
set(quick_deflate ${SYNTHETIC_DATASET_QUICK_DEFLATE})
if(NOT ISAL_FOUND OR NOT LIBDEFLATE_INCLUDE_DIR OR NOT LIBDEFLATE_LIBRARY)
  set(quick_deflate OFF)
  message(WARNING "PNG files will be compressed by zlib: the pixels are the same, but it takes several times as long, and the files' bytes differ from those of other systems. apt-get install libisal-dev libdeflate-dev")
endif()

# FreeImage has neither a CMake nor a pkg-config file.
find_path(FREEIMAGE_INCLUDE_DIR FreeImage.h)
find_library(FREEIMAGE_LIBRARY freeimage)
if(NOT FREEIMAGE_INCLUDE_DIR OR NOT FREEIMAGE_LIBRARY)
  message(FATAL_ERROR "FreeImage is needed: apt-get install libfreeimage-dev")
endif()

# Without it, everything except the set-up page is built.
pkg_check_modules(MICROHTTPD IMPORTED_TARGET libmicrohttpd)
if(NOT MICROHTTPD_FOUND)
  message(STATUS "setup_assistant is left out: apt-get install libmicrohttpd-dev")
endif()

# Without it, everything except `lidars` is built. Debian 11 and 12 and Ubuntu 20.04 have Embree 3, Debian 13 has 4.
option(SYNTHETIC_DATASET_LIDAR "Build lidars if Embree is there" ON)
foreach(version 4 3)
  if(SYNTHETIC_DATASET_LIDAR AND NOT EMBREE_FOUND)
    find_path(EMBREE${version}_INCLUDE_DIR embree${version}/rtcore.h)
    find_library(EMBREE${version}_LIBRARY embree${version})
    if(EMBREE${version}_INCLUDE_DIR AND EMBREE${version}_LIBRARY)
      set(EMBREE_FOUND TRUE)
      set(EMBREE_VERSION_MAJOR ${version})
      set(EMBREE_INCLUDE_DIR ${EMBREE${version}_INCLUDE_DIR})
      set(EMBREE_LIBRARY ${EMBREE${version}_LIBRARY})
    endif()
  endif()
endforeach()
if(NOT EMBREE_FOUND)
  message(STATUS "lidars are left out: apt-get install libembree-dev")
endif()
