#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// What the fuzzers share. An input may be refused with synthetic_dataset::Error, which the user is
/// shown; anything else that is thrown, and any fault that a sanitizer finds, is a crash.
namespace synthetic_dataset::fuzzing {

/// Does what may throw Error.
/// Ends the program where a process of its own (world/files/trial_process.h) has had a sanitizer
/// find a fault in it.
void tolerating(const std::function<void()>& read);

/// A folder for an input's files, one for each run of a fuzzer, in memory where there is /dev/shm.
[[nodiscard]] const std::filesystem::path& folder();

/// Writes a file below folder(), over an earlier input's. @return its path
std::filesystem::path write(const std::string& name, std::string_view content);

/// An input that is several files: the pieces between lines of "%%".
[[nodiscard]] std::vector<std::string> pieces(std::string_view input);

[[nodiscard]] inline std::string_view view(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace synthetic_dataset::fuzzing

/// What libFuzzer calls with each input (https://llvm.org/docs/LibFuzzer.html).
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
