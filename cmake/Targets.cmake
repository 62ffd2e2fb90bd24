# Warnings that every target of this repository is built with.
function(synthetic_dataset_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
endfunction()

# One folder of the core: a static library that no other package links.
#   synthetic_dataset_folder(motion SOURCES a.cpp LIBRARIES x)
# Libraries that are not ours are named as SYSTEM_INCLUDES' owners do: their headers are exempt from
# our warnings.
function(synthetic_dataset_folder name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES;SYSTEM_INCLUDES" ${ARGN})
  add_library(synthetic_dataset_${name} STATIC ${ARG_SOURCES})
  set_target_properties(synthetic_dataset_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_include_directories(synthetic_dataset_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
  target_include_directories(synthetic_dataset_${name} SYSTEM PUBLIC ${ARG_SYSTEM_INCLUDES})
  target_link_libraries(synthetic_dataset_${name} PUBLIC synthetic_dataset ${ARG_LIBRARIES})
  synthetic_dataset_warnings(synthetic_dataset_${name})
  synthetic_dataset_use_precompiled(synthetic_dataset_${name} core)
endfunction()
