# Builds everything with the flags that libFuzzer and the sanitizers need; only the fuzzers link
# libFuzzer's main (https://llvm.org/docs/LibFuzzer.html).
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  message(FATAL_ERROR "SYNTHETIC_DATASET_FUZZ needs clang: scripts/fuzz.sh configures with it")
endif()
set(fuzzing_options -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined
  -fno-omit-frame-pointer)
add_compile_options(${fuzzing_options})
add_link_options(-fsanitize=address,undefined)

# Adds a fuzzer for one reader: <name>_fuzz.cpp, with its seeds in corpus/<name>.
#   synthetic_dataset_fuzzer(bag LIBRARIES x)
function(synthetic_dataset_fuzzer name)
  cmake_parse_arguments(ARG "" "" "LIBRARIES" ${ARGN})
  add_executable(${name}_fuzz ${name}_fuzz.cpp)
  target_link_libraries(${name}_fuzz synthetic_dataset_fuzzing ${ARG_LIBRARIES})
  target_link_options(${name}_fuzz PRIVATE -fsanitize=fuzzer)
  synthetic_dataset_warnings(${name}_fuzz)
  add_dependencies(fuzzers ${name}_fuzz)
endfunction()
