#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>

namespace synthetic_dataset::run {

/// By which it is seen that a file's content is another one.
struct FileStamp {
  std::uintmax_t size = 0;  ///< [byte]
  std::filesystem::file_time_type changed;

  friend bool operator==(const FileStamp& a, const FileStamp& b) {
    return a.size == b.size && a.changed == b.changed;
  }
};

/// Nothing where there is no regular file.
[[nodiscard]] std::optional<FileStamp> stampOf(const std::filesystem::path& file);

/// What files were like when something was made of them.
class FileStamps {
 public:
  /// Begins before the files are read: what is written to meanwhile counts as changed.
  FileStamps() : begin_(std::filesystem::file_time_type::clock::now()) {}

  /// A file that was read, or was looked for and is not there. Once it was added, adding it again
  /// changes nothing.
  void add(const std::filesystem::path& file);

  /// Whether all files are as they were when they were added.
  [[nodiscard]] bool areCurrent() const;

 private:
  std::filesystem::file_time_type begin_;
  std::map<std::filesystem::path, std::optional<FileStamp>> stamps_;
  bool has_changed_ = false;  ///< while it was read
};

}  // namespace synthetic_dataset::run
