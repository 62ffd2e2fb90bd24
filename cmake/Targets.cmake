# Warnings that every target of this repository is built with.
function(synthetic_dataset_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
endfunction()

# Several sources are compiled as one, since reading the same headers is most of a build. Each source
# still compiles by itself, which a stage of .ci/run checks.
option(SYNTHETIC_DATASET_UNITY "Compile several sources as one" ON)
function(synthetic_dataset_unity target)
  if(SYNTHETIC_DATASET_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16)
    # Classes of one source that hold types of its unnamed namespace look like a header's.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

set(synthetic_dataset_rarely_run $<$<CONFIG:RelWithDebInfo>:-O1> $<$<CONFIG:RelWithDebInfo>:-g0>)

# One room of the core: a static library of all sources in a folder, that no other package links.
#   synthetic_dataset_room(motion LIBRARIES x)
# EXCLUDE names sources that are not of the library. Libraries that are not ours are named as
# SYSTEM_INCLUDES' owners do: their headers are exempt from our warnings.
# RARELY_RUN: its code runs once a run or a scene, not once a pixel, so that to optimise it takes
# longer than it saves.
function(synthetic_dataset_room name)
  cmake_parse_arguments(ARG "RARELY_RUN" "" "EXCLUDE;LIBRARIES;SYSTEM_INCLUDES" ${ARGN})
  file(GLOB_RECURSE sources RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS *.cpp)
  if(ARG_EXCLUDE)
    list(REMOVE_ITEM sources ${ARG_EXCLUDE})
  endif()
  add_library(synthetic_dataset_${name} STATIC ${sources})
  set_target_properties(synthetic_dataset_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_include_directories(synthetic_dataset_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_include_directories(synthetic_dataset_${name} SYSTEM PUBLIC ${ARG_SYSTEM_INCLUDES})
  target_link_libraries(synthetic_dataset_${name} PUBLIC synthetic_dataset ${ARG_LIBRARIES})
  synthetic_dataset_warnings(synthetic_dataset_${name})
  synthetic_dataset_unity(synthetic_dataset_${name})
  if(ARG_RARELY_RUN)
    target_compile_options(synthetic_dataset_${name} PRIVATE ${synthetic_dataset_rarely_run})
    synthetic_dataset_use_precompiled(synthetic_dataset_${name} rarely_run)
  else()
    synthetic_dataset_use_precompiled(synthetic_dataset_${name} core)
  endif()
endfunction()
