#include "base/image/picture_size.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <string>

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

/// A height that is negative says that the first row is on top.
Size bmpSize(const PictureBytes& file) {
  if (file.little(14, 4) == 12) return PictureSize{file.little(18, 2), file.little(20, 2)};
  const std::uint64_t height = file.little(22, 4);
  const bool negative = (height & 0x80000000U) != 0;
  return PictureSize{file.little(18, 4), negative ? 0x100000000U - height : height};
}

/// The line behind the header's empty one: "-Y height +X width" (Ward, "Real Pixels", 1991).
Size radianceSize(const Bytes& bytes) {
  static constexpr char kHeaderEnd[] = {'\n', '\n'};
  auto at = std::search(bytes.begin(), bytes.end(), std::begin(kHeaderEnd), std::end(kHeaderEnd));
  if (at == bytes.end()) return std::nullopt;
  at += std::size(kHeaderEnd);
  std::istringstream line(std::string(at, std::find(at, bytes.end(), '\n')));
  std::string down;
  std::string right;
  PictureSize size;
  line >> down >> size.height >> right >> size.width;
  if (!line || down != "-Y" || right != "+X") return std::nullopt;
  return size;
}

/// The pixels that are there: the header's attribute "dataWindow", a Box2i (OpenEXR file layout).
Size exrSize(const PictureBytes& file) {
  const auto text = [&](std::size_t& at) {
    std::string found;
    for (; file.byte(at) != 0; ++at) found += static_cast<char>(file.byte(at));
    ++at;
    return found;
  };
  for (std::size_t at = 8; at < file.size();) {
    const std::string name = text(at);
    if (name.empty()) return std::nullopt;  // the header's end
    static_cast<void>(text(at));            // its type
    const std::size_t value = at + 4;
    const auto corner = [&](std::size_t i) {
      return static_cast<std::int32_t>(static_cast<std::uint32_t>(file.little(value + 4 * i, 4)));
    };
    if (name == "dataWindow") {
      const std::int64_t width = std::int64_t{corner(2)} - corner(0) + 1;
      const std::int64_t height = std::int64_t{corner(3)} - corner(1) + 1;
      if (width <= 0 || height <= 0) return std::nullopt;
      return PictureSize{static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height)};
    }
    at = value + file.little(at, 4);
  }
  return std::nullopt;
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
  if (isRadiance(file)) return radianceSize(bytes);
  if (isOpenExr(file)) return exrSize(file);
  if (looksLikeTga(file)) return PictureSize{file.little(12, 2), file.little(14, 2)};
  return std::nullopt;
}

}  // namespace synthetic_dataset::base
