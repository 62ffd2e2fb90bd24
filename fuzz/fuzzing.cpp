#include "fuzzing.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <stdexcept>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::fuzzing {
namespace {

namespace fs = std::filesystem;

/// The exit code of a child that a sanitizer ends; scripts/fuzz.sh sets it (exitcode=99).
const std::string kChildsFault = "exit code 99)";

/// Compares by hash: libFuzzer learns which texts are compared, and would generate them.
bool isOfAChildsFault(const std::string& message) {
  if (message.size() < kChildsFault.size()) return false;
  const std::hash<std::string> hash;
  return hash(message.substr(message.size() - kChildsFault.size())) == hash(kChildsFault);
}

class Folder {
 public:
  Folder() {
    std::error_code ignored;
    const bool has_memory = fs::is_directory("/dev/shm", ignored);
    std::string pattern =
        ((has_memory ? fs::path("/dev/shm") : fs::temp_directory_path()) / "fuzzing_XXXXXX")
            .string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot make " + pattern);
    path_ = pattern;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

void tolerating(const std::function<void()>& read) {
  try {
    read();
  } catch (const Error& error) {
    if (!isOfAChildsFault(error.what())) return;
    std::fprintf(stderr, "a child process failed: %s\n", error.what());
    std::abort();
  }
}

const fs::path& folder() {
  static const Folder kFolder;
  return kFolder.path();
}

fs::path write(const std::string& name, std::string_view content) {
  const fs::path file = folder() / name;
  fs::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  return file;
}

std::vector<std::string> pieces(std::string_view input) {
  constexpr std::string_view kMark = "\n%%\n";
  std::vector<std::string> result;
  while (true) {
    const std::size_t end = input.find(kMark);
    result.emplace_back(input.substr(0, end));
    if (end == std::string_view::npos) return result;
    input.remove_prefix(end + kMark.size());
  }
}

}  // namespace synthetic_dataset::fuzzing
