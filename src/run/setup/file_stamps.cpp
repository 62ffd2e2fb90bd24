#include "run/setup/file_stamps.h"

#include <algorithm>
#include <system_error>

namespace synthetic_dataset::run {

namespace fs = std::filesystem;

std::optional<FileStamp> stampOf(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return std::nullopt;
  FileStamp stamp;
  stamp.size = fs::file_size(file, error);
  if (!error) stamp.changed = fs::last_write_time(file, error);
  return error ? std::nullopt : std::optional(stamp);
}

void FileStamps::add(const fs::path& file) {
  const auto [added, is_new] = stamps_.try_emplace(file);
  if (!is_new) return;
  added->second = stampOf(file);
  has_changed_ = has_changed_ || (added->second && added->second->changed > begin_);
}

bool FileStamps::areCurrent() const {
  return !has_changed_ && std::all_of(stamps_.begin(), stamps_.end(), [](const auto& entry) {
    return stampOf(entry.first) == entry.second;
  });
}

}  // namespace synthetic_dataset::run
