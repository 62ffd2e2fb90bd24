#include "base/image/picture_check.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>

#include "base/image/light_file.h"
#include "base/image/picture_bytes.h"

namespace synthetic_dataset::base {
namespace {

bool isWholeJpeg(const std::vector<std::uint8_t>& bytes) {
  const PictureBytes file(bytes);
  const std::size_t scan = findSegment(file, [](std::uint8_t marker) { return marker == 0xDA; });
  const std::uint8_t end[] = {0xFF, 0xD9};
  const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(std::min(scan, bytes.size()));
  return std::search(from, bytes.end(), std::begin(end), std::end(end)) != bytes.end();
}

std::uint64_t bytesFor(std::uint64_t bits) { return (bits + 7) / 8; }

/// The end of rows of `step` bytes each, except for the last, which has `last`.
std::uint64_t endOfRows(std::uint64_t from, std::uint64_t rows, std::uint64_t step,
                        std::uint64_t last) {
  return rows == 0 ? from : from + (rows - 1) * step + last;
}

/// Header, text, palette and pixels; run-length encoded pixels come in packets of up to 128
/// (Truevision TGA specification 2.0, "TGA File Header" and appendix C).
bool isWholeTga(const PictureBytes& file) {
  constexpr std::size_t kHeader = 18;
  const std::uint64_t palette =
      file.byte(1) == 1 ? file.little(5, 2) * bytesFor(file.byte(7)) : std::uint64_t{0};
  const std::uint64_t pixels = file.little(12, 2) * file.little(14, 2);
  const std::uint64_t pixel_size = bytesFor(file.byte(16));
  std::uint64_t at = kHeader + file.byte(0) + palette;
  const bool is_packed = file.byte(2) >= 9;
  if (!is_packed) return at + pixels * pixel_size <= file.size();
  for (std::uint64_t done = 0; done < pixels;) {
    if (at >= file.size()) return false;
    const std::uint8_t head = file.byte(at);
    const std::uint64_t count = (head & 0x7FU) + std::uint64_t{1};
    const bool is_run = (head & 0x80U) != 0;
    at += 1 + (is_run ? pixel_size : count * pixel_size);
    done += count;
  }
  return at <= file.size();
}

/// DDS_HEADER and DDS_PIXELFORMAT of Direct3D's "Programming Guide for DDS": blocks of 4 x 4
/// pixels, or rows. Smaller copies of the picture may follow.
bool isWholeDds(const PictureBytes& file) {
  constexpr std::uint64_t kHeader = 128;
  constexpr std::uint64_t kHasPitch = 0x8;
  constexpr std::uint64_t kHasCode = 0x4;
  const std::uint64_t height = file.little(12, 4);
  const std::uint64_t width = file.little(16, 4);
  if ((file.little(80, 4) & kHasCode) != 0) {
    const std::uint64_t block = file.has(84, "DXT1") ? 8 : 16;
    return kHeader + (width + 3) / 4 * ((height + 3) / 4) * block <= file.size();
  }
  const std::uint64_t row = bytesFor(width * file.little(88, 4));
  const std::uint64_t step = (file.little(8, 4) & kHasPitch) != 0 ? file.little(20, 4) : row;
  return endOfRows(kHeader, height, step, row) <= file.size();
}

/// BITMAPFILEHEADER and BITMAPINFOHEADER of Windows; rows start at multiples of 4 bytes.
/// A negative height means that the first row is on top.
bool isWholeBmp(const PictureBytes& file) {
  const bool is_old = file.little(14, 4) == 12;
  const std::uint64_t compression = is_old ? 0 : file.little(30, 4);
  const bool has_rows = compression == 0 || compression == 3;
  if (!has_rows) return true;
  const std::uint64_t width = is_old ? file.little(18, 2) : file.little(18, 4);
  const std::uint64_t signed_height = is_old ? file.little(20, 2) : file.little(22, 4);
  const std::uint64_t height =
      !is_old && (signed_height & 0x80000000U) != 0 ? 0x100000000U - signed_height : signed_height;
  const std::uint64_t row = bytesFor(width * file.little(is_old ? 24 : 28, 2));
  return endOfRows(file.little(10, 4), height, (row + 3) / 4 * 4, row) <= file.size();
}

/// The size of the palette that a GIF's packed field announces [bytes].
std::uint64_t gifPalette(std::uint8_t packed) {
  return (packed & 0x80U) != 0 ? std::uint64_t{3} << ((packed & 0x07U) + 1U) : 0;
}

/// Blocks up to the last one of the first picture (GIF89a, sections 15, 18, 20, 22 and 24).
bool isWholeGif(const PictureBytes& file) {
  constexpr std::uint8_t kExtension = 0x21;
  constexpr std::uint8_t kPicture = 0x2C;
  std::uint64_t at = 13 + gifPalette(file.byte(10));
  while (at < file.size()) {
    const std::uint8_t kind = file.byte(at);
    if (kind != kExtension && kind != kPicture) return true;  // damaged in another way
    at += kind == kExtension ? 2 : 11 + gifPalette(file.byte(at + 9));
    while (at < file.size() && file.byte(at) != 0) at += 1 + std::uint64_t{file.byte(at)};
    if (kind == kPicture) return at < file.size();
    ++at;
  }
  return false;
}

/// The sections before the pixels, then the pixels channel by channel, either raw or as packed rows
/// preceded by their sizes (Adobe Photoshop File Formats Specification, "Image Data Section").
/// Version 2 has larger fields.
bool isWholePsd(const PictureBytes& file) {
  const bool is_large = file.big(4, 2) == 2;
  const std::uint64_t rows = file.big(12, 2) * file.big(14, 4);
  std::uint64_t at = 26;
  for (const std::size_t length :
       {std::size_t{4}, std::size_t{4}, std::size_t{is_large ? 8U : 4U}}) {
    const std::uint64_t size = file.big(at, length);
    if (size > file.size() || at + length > file.size()) return false;
    at += length + size;
  }
  const std::uint64_t compression = file.big(at, 2);
  at += 2;
  if (compression == 0)
    return at + rows * bytesFor(file.big(18, 4) * file.big(22, 2)) <= file.size();
  if (compression != 1) return at < file.size();
  const std::size_t count = is_large ? 4 : 2;
  std::uint64_t end = at + rows * count;
  if (end > file.size()) return false;
  for (std::uint64_t row = 0; row < rows; ++row) end += file.big(at + row * count, count);
  return end <= file.size();
}

using Bytes = std::vector<std::uint8_t>;

constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::size_t kChunkFrame = 12;  // length, type and checksum of a chunk

std::uint32_t bigEndian(const Bytes& file, std::size_t at) {
  return static_cast<std::uint32_t>(file[at]) << 24U |
         static_cast<std::uint32_t>(file[at + 1]) << 16U |
         static_cast<std::uint32_t>(file[at + 2]) << 8U | file[at + 3];
}

/// The lookup table for the checksum, by byte.
std::array<std::uint32_t, 256> makeChecksumTable() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < table.size(); ++byte) {
    std::uint32_t sum = byte;
    for (int bit = 0; bit < 8; ++bit) sum = (sum & 1U) != 0 ? 0xEDB88320U ^ (sum >> 1U) : sum >> 1U;
    table[byte] = sum;
  }
  return table;
}

/// The checksum of a chunk (PNG specification, annex D).
std::uint32_t checksum(const Bytes& file, std::size_t from, std::size_t to) {
  static const std::array<std::uint32_t, 256> kTable = makeChecksumTable();
  std::uint32_t sum = 0xFFFFFFFFU;
  for (std::size_t i = from; i < to; ++i) sum = kTable[(sum ^ file[i]) & 0xFFU] ^ (sum >> 8U);
  return ~sum;
}

bool makesPixels(const std::string& type) {
  return type == "IHDR" || type == "PLTE" || type == "tRNS" || type == "IDAT" || type == "IEND";
}

}  // namespace

bool isWhole(const std::vector<std::uint8_t>& bytes) {
  const PictureBytes file(bytes);
  if (isJpeg(file)) return isWholeJpeg(bytes);
  if (file.has(0, "\x89PNG")) return true;
  if (file.has(0, "GIF8")) return isWholeGif(file);
  if (file.has(0, "BM")) return isWholeBmp(file);
  if (file.has(0, "DDS ")) return isWholeDds(file);
  if (file.has(0, "8BPS")) return isWholePsd(file);
  if (isLight(file)) return isWholeLight(file);
  const bool is_other =
      file.has(0, "RIFF") || file.has(0, "II*") || file.has(0, std::string("MM\0*", 4));
  return is_other || !looksLikeTga(file) || isWholeTga(file);
}

Bytes essentialPngChunks(const Bytes& file) {
  if (file.size() < kSignature.size() ||
      !std::equal(kSignature.begin(), kSignature.end(), file.begin())) {
    return file;
  }
  Bytes result(kSignature.begin(), kSignature.end());
  for (std::size_t at = kSignature.size(); file.size() - at >= kChunkFrame;) {
    const std::size_t length = bigEndian(file, at);
    if (length > file.size() - at - kChunkFrame) return {};
    const std::size_t end = at + kChunkFrame + length;
    const auto type_at = file.begin() + static_cast<std::ptrdiff_t>(at) + 4;
    const std::string type(type_at, type_at + 4);
    if (makesPixels(type)) {
      if (checksum(file, at + 4, end - 4) != bigEndian(file, end - 4)) return {};
      result.insert(result.end(), type_at - 4, file.begin() + static_cast<std::ptrdiff_t>(end));
    }
    if (type == "IEND") return result;
    at = end;
  }
  return {};
}

}  // namespace synthetic_dataset::base
