#include "motion/ros2/file_window.h"

#include <algorithm>
#include <utility>

#include "base/input_file.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {

FileWindow::FileWindow(const std::string& file) : stream_(base::openInput(file)) {
  stream_.seekg(0, std::ios::end);
  size_ = stream_ ? static_cast<std::uint64_t>(stream_.tellg()) : 0;
}

std::string_view FileWindow::at(std::uint64_t place, std::uint64_t count) {
  if (place > size_ || count > size_ - place) throw Error("a record goes beyond the file's end");
  if (place < begin_ || place + count > begin_ + bytes_.size()) {
    constexpr std::uint64_t kAtOnce = std::uint64_t{1} << 16U;
    std::string fresh(std::min(size_ - place, std::max(count, kAtOnce)), '\0');
    stream_.seekg(static_cast<std::streamoff>(place));
    stream_.read(fresh.data(), static_cast<std::streamsize>(fresh.size()));
    if (!stream_) throw Error("it cannot be read");
    bytes_ = std::move(fresh);
    begin_ = place;
  }
  return std::string_view(bytes_).substr(place - begin_, count);
}

}  // namespace synthetic_dataset::motion
