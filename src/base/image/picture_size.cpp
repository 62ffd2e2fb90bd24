#include "base/image/picture_size.h"

#include <cstddef>
#include <string>

#include "base/image/light_file.h"
#include "base/image/picture_bytes.h"

namespace synthetic_dataset::base {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Size = std::optional<PictureSize>;

bool isFrame(std::uint8_t marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

Size jpegSize(const PictureBytes& file) {
  const std::size_t at = findSegment(file, isFrame);
  return PictureSize{file.big(at + 7, 2), file.big(at + 5, 2)};
}

/// WebP's three kinds of content (RFC 9649, section 2).
Size webpSize(const PictureBytes& file) {
  if (file.has(12, "VP8X")) return PictureSize{file.little(24, 3) + 1, file.little(27, 3) + 1};
  if (file.has(12, "VP8L")) {
    const std::uint64_t bits = file.little(21, 4);
    return PictureSize{(bits & 0x3FFFU) + 1, (bits >> 14U & 0x3FFFU) + 1};
  }
  return PictureSize{file.little(26, 2) & 0x3FFFU, file.little(28, 2) & 0x3FFFU};
}

/// ImageWidth and ImageLength of the first directory (TIFF 6.0, section 2).
Size tiffSize(const PictureBytes& file) {
  const bool is_little = file.byte(0) == 'I';
  const auto read = [&](std::size_t at, std::size_t bytes) {
    return is_little ? file.little(at, bytes) : file.big(at, bytes);
  };
  constexpr std::uint64_t kShort = 3;
  PictureSize size;
  const std::size_t directory = read(4, 4);
  const std::uint64_t entries = read(directory, 2);
  for (std::uint64_t i = 0; i < entries; ++i) {
    const std::size_t entry = directory + 2 + 12 * i;
    const std::uint64_t tag = read(entry, 2);
    const std::uint64_t value = read(entry + 8, read(entry + 2, 2) == kShort ? 2 : 4);
    if (tag == 256) size.width = value;
    if (tag == 257) size.height = value;
  }
  return size;
}

/// A negative height means that the first row is on top.
Size bmpSize(const PictureBytes& file) {
  if (file.little(14, 4) == 12) return PictureSize{file.little(18, 2), file.little(20, 2)};
  const std::uint64_t height = file.little(22, 4);
  const bool negative = (height & 0x80000000U) != 0;
  return PictureSize{file.little(18, 4), negative ? 0x100000000U - height : height};
}

}  // namespace

Size claimedSize(const Bytes& bytes) {
  const PictureBytes file(bytes);
  if (file.has(0, "\x89PNG")) return PictureSize{file.big(16, 4), file.big(20, 4)};
  if (isJpeg(file)) return jpegSize(file);
  if (file.has(0, "GIF8")) return PictureSize{file.little(6, 2), file.little(8, 2)};
  if (file.has(0, "BM")) return bmpSize(file);
  if (file.has(0, "RIFF") && file.has(8, "WEBP")) return webpSize(file);
  if (file.has(0, "II*") || file.has(0, std::string("MM\0*", 4))) return tiffSize(file);
  if (file.has(0, "DDS ")) return PictureSize{file.little(16, 4), file.little(12, 4)};
  if (file.has(0, "8BPS")) return PictureSize{file.big(18, 4), file.big(14, 4)};
  if (isLight(file)) return lightSize(file);
  if (looksLikeTga(file)) return PictureSize{file.little(12, 2), file.little(14, 2)};
  return std::nullopt;
}

}  // namespace synthetic_dataset::base
