# Precompiles headers that nearly every file includes: parsing headers is half of a build.
# A compiler cache cannot see through precompiled headers, so they are off if there is one
# (-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); files compile without them, as each includes what it uses.
set(precompile_default ON)
if(CMAKE_CXX_COMPILER_LAUNCHER OR CMAKE_VERSION VERSION_LESS 3.16)
  set(precompile_default OFF)
endif()
option(SYNTHETIC_DATASET_PRECOMPILE "Precompile the headers that most files share"
  ${precompile_default})

set(synthetic_dataset_common_headers
  <algorithm> <array> <chrono> <cmath> <filesystem> <fstream> <functional> <iterator> <limits> <map>
  <memory> <optional> <ostream> <random> <set> <sstream> <string> <tuple> <variant> <vector>
  <Eigen/Geometry> <opencv2/imgproc.hpp>)

# Precompiles the common headers and the given HEADERS for targets of one kind. All of these must be
# compiled with the same flags, so properties that affect the flags have to be given here too.
#   synthetic_dataset_precompiled(core HEADERS <x.h> LIBRARIES y PROPERTIES CXX_VISIBILITY_PRESET hidden)
function(synthetic_dataset_precompiled kind)
  cmake_parse_arguments(ARG "" "" "HEADERS;LIBRARIES;PROPERTIES" ${ARGN})
  if(NOT SYNTHETIC_DATASET_PRECOMPILE)
    return()
  endif()
  set(target synthetic_dataset_precompiled_${kind})
  add_library(${target} STATIC EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
  target_include_directories(${target} SYSTEM PRIVATE ${EIGEN3_INCLUDE_DIRS} ${OpenCV_INCLUDE_DIRS})
  target_link_libraries(${target} PRIVATE ${ARG_LIBRARIES})
  target_precompile_headers(${target} PRIVATE ${synthetic_dataset_common_headers} ${ARG_HEADERS})
  if(ARG_PROPERTIES)
    set_target_properties(${target} PROPERTIES ${ARG_PROPERTIES})
  endif()
  synthetic_dataset_warnings(${target})
endfunction()

# Lets a target use the precompiled headers of its kind.
function(synthetic_dataset_use_precompiled target kind)
  if(TARGET synthetic_dataset_precompiled_${kind})
    target_precompile_headers(${target} REUSE_FROM synthetic_dataset_precompiled_${kind})
  endif()
endfunction()
