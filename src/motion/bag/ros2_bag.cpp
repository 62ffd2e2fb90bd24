#include "motion/bag/ros2_bag.h"

#include "base/input_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace synthetic_dataset::motion {
namespace {

namespace fs = std::filesystem;

bool beginsWith(const fs::path& file, const std::string& magic) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return false;
  std::ifstream stream = base::openInput(file);
  std::string start(magic.size(), '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  return stream.gcount() == static_cast<std::streamsize>(magic.size()) && start == magic;
}

bool isFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool hasBagInside(const fs::path& folder) {
  if (isFile(folder / "metadata.yaml")) return true;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (isRos2Bag(entry->path().string()) && isFile(entry->path())) return true;
  }
  return false;
}

/// For a shell.
std::string quoted(const std::string& text) {
  static const std::string kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./+,:@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

}  // namespace

bool isRos2Bag(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return hasBagInside(path);
  if (!isFile(path)) return false;
  const std::string extension = fs::path(path).extension().string();
  const bool is_compressed = extension == ".zstd" && beginsWith(path, "\x28\xB5\x2F\xFD");
  // https://mcap.dev/spec#magic, https://www.sqlite.org/fileformat.html#magic_header_string
  return is_compressed || beginsWith(path, "\x89MCAP") ||
         beginsWith(path, std::string("SQLite format 3\0", 16));
}

std::string convertAdvice(const std::string& path) {
  fs::path plain = path;
  if (!plain.has_filename()) plain = plain.parent_path();  // "run/"
  std::error_code ignored;
  if (!fs::is_directory(plain, ignored)) {
    while (plain.has_extension()) plain.replace_extension();
  }
  return "is a bag of ROS 2, and those of ROS 1 are read; this makes one: `pip install rosbags`, "
         "then `rosbags-convert --src " +
         quoted(path) + " --dst " + quoted(plain.string() + ".bag") +
         " --src-typestore ros2_humble --dst-typestore ros1_noetic` (docs/recordings.md)";
}

}  // namespace synthetic_dataset::motion
