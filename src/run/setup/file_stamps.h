#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>

namespace synthetic_dataset::run {

/// Size and modification time, which reveal whether a file's content has changed.
struct FileStamp {
  std::uintmax_t size = 0;  ///< [byte]
  std::filesystem::file_time_type changed;

  friend bool operator==(const FileStamp& a, const FileStamp& b) {
    return a.size == b.size && a.changed == b.changed;
  }
};

/// Nothing if there is no regular file.
[[nodiscard]] std::optional<FileStamp> stampOf(const std::filesystem::path& file);

/// The state of files when something was made from them.
class FileStamps {
 public:
  /// Construct before reading the files: a file that is written to in the meantime counts as
  /// changed.
  FileStamps() : begin_(std::filesystem::file_time_type::clock::now()) {}

  /// Adds a file that was read, or that was looked for and does not exist. Adding a file again has
  /// no effect.
  void add(const std::filesystem::path& file);

  /// Whether all files are as they were when they were added.
  [[nodiscard]] bool areCurrent() const;

 private:
  std::filesystem::file_time_type begin_;
  std::map<std::filesystem::path, std::optional<FileStamp>> stamps_;
  bool has_changed_ = false;  ///< while being read
};

}  // namespace synthetic_dataset::run
