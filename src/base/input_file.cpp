#include "base/input_file.h"

#include <iterator>
#include <system_error>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPipe = "is a pipe or a device; a file is needed";

}  // namespace

std::string inputFault(const fs::path& file) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (!fs::exists(status) || fs::is_regular_file(status)) return "";
  return fs::is_directory(status) ? "is a folder; a file is needed" : kPipe;
}

bool isAboutPipe(std::string_view message) { return message.find(kPipe) != std::string_view::npos; }

std::ifstream openInput(const fs::path& file) {
  const std::string fault = inputFault(file);
  if (!fault.empty()) throw Error(file.string() + ": " + fault);
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error(file.string() + ": no such file, or it cannot be read");
  return stream;
}

std::string readInput(const fs::path& file) {
  std::ifstream stream = openInput(file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<std::uint8_t> readInputBytes(const fs::path& file) {
  std::ifstream stream = openInput(file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace synthetic_dataset::base
