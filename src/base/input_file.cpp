#include "base/input_file.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <system_error>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::base {
namespace {

namespace fs = std::filesystem;

/// The innermost watch of this thread; files are opened too deep in the call stack to pass it down.
thread_local InputWatch* watch = nullptr;

constexpr const char* kPipe = "is a pipe or a device; a file is needed";

}  // namespace

std::string inputFault(const fs::path& file) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (!fs::exists(status) || fs::is_regular_file(status)) return "";
  return fs::is_directory(status) ? "is a folder; a file is needed" : kPipe;
}

std::string compressionFault(std::string_view start) {
  struct Kind {
    std::string_view start;
    const char* program;
  };
  static constexpr std::array<Kind, 5> kKinds = {{{"\x1f\x8b", "gunzip"},
                                                  {"BZh", "bunzip2"},
                                                  {"\xfd"
                                                   "7zXZ",
                                                   "unxz"},
                                                  {"\x28\xb5\x2f\xfd", "unzstd"},
                                                  {"PK\x03\x04", "unzip"}}};
  for (const Kind& kind : kKinds) {
    if (start.substr(0, kind.start.size()) == kind.start) {
      return std::string("is compressed; `") + kind.program + "` unpacks it";
    }
  }
  return "";
}

std::string textFault(std::string_view bytes) {
  const std::string compressed = compressionFault(bytes);
  if (!compressed.empty()) return compressed;
  const std::string_view mark = bytes.substr(0, 2);
  if (mark == "\xff\xfe" || mark == "\xfe\xff") {
    return "is UTF-16; it should be UTF-8, which editors can save";
  }
  return bytes.find('\0') == std::string_view::npos ? "" : "is not a text file";
}

std::string didYouMeanFile(const fs::path& file) {
  constexpr std::size_t kMost = 10000;  // larger folders are not searched
  std::error_code error;
  if (fs::exists(file, error)) return "";
  std::vector<std::string> names;
  for (auto each =
           fs::directory_iterator(file.parent_path().empty() ? "." : file.parent_path(), error);
       !error && each != fs::directory_iterator(); each.increment(error)) {
    names.push_back(each->path().filename().string());
    if (names.size() > kMost) return "";
  }
  std::sort(names.begin(), names.end());  // so that ties are always resolved alike
  return didYouMean(file.filename().string(), names);
}

bool isAboutPipe(std::string_view message) { return message.find(kPipe) != std::string_view::npos; }

InputWatch::InputWatch() : outer_(watch) { watch = this; }

InputWatch::~InputWatch() { watch = outer_; }

void InputWatch::note(const fs::path& file) {
  for (InputWatch* each = watch; each != nullptr; each = each->outer_) each->files_.insert(file);
}

std::ifstream openInput(const fs::path& file) {
  InputWatch::note(file);
  const std::string fault = inputFault(file);
  if (!fault.empty()) throw Error(file.string() + ": " + fault);
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw Error(file.string() + ": no such file, or it cannot be read" + didYouMeanFile(file));
  }
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
