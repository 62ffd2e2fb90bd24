#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace synthetic_dataset::base {

/// Reads numbers from a picture file; 0 beyond its end.
class PictureBytes {
 public:
  explicit PictureBytes(const std::vector<std::uint8_t>& file) : file_(file) {}

  [[nodiscard]] std::uint64_t little(std::size_t at, std::size_t bytes) const {
    std::uint64_t value = 0;
    for (std::size_t i = bytes; i-- > 0;) value = value << 8U | byte(at + i);
    return value;
  }
  [[nodiscard]] std::uint64_t big(std::size_t at, std::size_t bytes) const {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) value = value << 8U | byte(at + i);
    return value;
  }
  [[nodiscard]] bool has(std::size_t at, const std::string& mark) const {
    return file_.size() >= at + mark.size() &&
           std::equal(mark.begin(), mark.end(), file_.begin() + static_cast<std::ptrdiff_t>(at),
                      [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
  }
  [[nodiscard]] std::uint8_t byte(std::size_t at) const {
    return at < file_.size() ? file_[at] : std::uint8_t{0};
  }
  [[nodiscard]] std::size_t size() const { return file_.size(); }

 private:
  const std::vector<std::uint8_t>& file_;
};

/// The offset of the first segment of a JPEG file whose marker is wanted (ITU T.81, annex B), or
/// the file's end.
template <class Wanted>
[[nodiscard]] std::size_t findSegment(const PictureBytes& file, Wanted isWanted) {
  std::size_t at = 2;
  while (at + 4 <= file.size() && file.byte(at) == 0xFF) {
    const std::uint8_t marker = file.byte(at + 1);
    if (isWanted(marker)) return at;
    const bool filler = marker == 0xFF;
    const bool alone = marker == 0x01 || (marker >= 0xD0 && marker <= 0xD8);
    if (filler) {
      at += 1;
    } else {
      at += alone ? 2 : 2 + file.big(at + 2, 2);
    }
  }
  return file.size();
}

[[nodiscard]] inline bool isJpeg(const PictureBytes& file) { return file.has(0, "\xFF\xD8\xFF"); }

/// Recognizes TGA, which has no magic number, by the few values that its header may have.
[[nodiscard]] inline bool looksLikeTga(const PictureBytes& file) {
  const std::uint8_t kind = file.byte(2);
  const std::uint8_t depth = file.byte(16);
  const bool kind_known = (kind >= 1 && kind <= 3) || (kind >= 9 && kind <= 11);
  const bool depth_known = depth == 8 || depth == 15 || depth == 16 || depth == 24 || depth == 32;
  return file.size() >= 18 && file.byte(1) <= 1 && kind_known && depth_known;
}

}  // namespace synthetic_dataset::base
