#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// The common parts of the fuzzers. An input may be refused with synthetic_dataset::Error, which
/// the user is shown; any other exception, and any fault that a sanitizer finds, is a crash.
namespace synthetic_dataset::fuzzing {

/// Runs something that may throw Error.
/// Ends the program if a sanitizer has found a fault in a child process
/// (world/files/trial_process.h).
void tolerating(const std::function<void()>& read);

/// A folder for an input's files, one for each run of a fuzzer, in memory if /dev/shm exists.
[[nodiscard]] const std::filesystem::path& folder();

/// Writes a file below folder(), replacing that of an earlier input. @return its path
std::filesystem::path write(const std::string& name, std::string_view content);

/// Splits an input that stands for several files at lines of "%%".
[[nodiscard]] std::vector<std::string> pieces(std::string_view input);

[[nodiscard]] inline std::string_view view(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace synthetic_dataset::fuzzing

/// What libFuzzer calls with each input (https://llvm.org/docs/LibFuzzer.html).
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
