# Enables the warnings that every target of this repository is built with.
function(synthetic_dataset_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
endfunction()

# Compiles several sources as one, since parsing the same headers is most of a build. Each source
# still compiles by itself; a stage of .ci/run checks this.
option(SYNTHETIC_DATASET_UNITY "Compile several sources as one" ON)
function(synthetic_dataset_unity target)
  if(SYNTHETIC_DATASET_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16)
    # The sources of a unity build look like headers to GCC, which warns about classes in headers
    # with members whose types are in an unnamed namespace.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

set(synthetic_dataset_rarely_run $<$<CONFIG:RelWithDebInfo>:-O1> $<$<CONFIG:RelWithDebInfo>:-g0>)

# Adds one room of the core: a static library of a folder's sources, which no other package links.
#   synthetic_dataset_room(motion LIBRARIES x)
# EXCLUDE: sources that do not belong to the library. SYSTEM_INCLUDES: include folders of third-party
# libraries, whose headers are exempt from our warnings.
# RARELY_RUN: for code that runs once per run or scene, not once per pixel, so that optimising it
# takes longer than it saves.
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
