#include "base/image/picture_file.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>

namespace synthetic_dataset::base {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::size_t kChunkFrame = 12;  // length, type and checksum of a chunk

std::uint32_t bigEndian(const Bytes& file, std::size_t at) {
  return static_cast<std::uint32_t>(file[at]) << 24U |
         static_cast<std::uint32_t>(file[at + 1]) << 16U |
         static_cast<std::uint32_t>(file[at + 2]) << 8U | file[at + 3];
}

/// What each value of a byte makes of a checksum.
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

Bytes withoutColourProfile(const Bytes& file) {
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
