#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace synthetic_dataset::motion {

/// Kinds of MCAP's records (https://mcap.dev/spec#records) that are read.
enum class McapRecord : std::uint8_t {
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kDataEnd = 0x0F,
};

/// A record begins with its kind in one byte, and the length of its content in eight.
inline constexpr std::size_t kMcapRecordHead = 9;

inline constexpr std::string_view kMcapMagic = "\x89MCAP0\r\n";

/// Takes little-endian values from bytes. Methods throw Error if there are too few bytes.
class McapBytes {
 public:
  explicit McapBytes(std::string_view bytes) : rest_(bytes) {}

  template <class Number>
  [[nodiscard]] Number number() {
    Number value = 0;
    const std::string_view bytes = take(sizeof(Number));
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      value = static_cast<Number>(
          value | static_cast<Number>(static_cast<Number>(static_cast<unsigned char>(bytes[i]))
                                      << (8U * i)));
    }
    return value;
  }
  [[nodiscard]] std::string_view take(std::uint64_t count);
  /// A text, preceded by its length.
  [[nodiscard]] std::string_view text() { return take(number<std::uint32_t>()); }
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

struct McapSchema {
  std::uint16_t id = 0;
  std::string name;
  std::string encoding;
  std::string text;
};
[[nodiscard]] McapSchema mcapSchema(std::string_view content);

struct McapChannel {
  std::uint16_t id = 0;
  std::uint16_t schema = 0;  ///< 0: none
  std::string topic;
  std::string encoding;
};
[[nodiscard]] McapChannel mcapChannel(std::string_view content);

struct McapMessage {
  static constexpr std::size_t kHead = 2 + 4 + 8 + 8;  ///< [byte] before the data

  std::uint16_t channel = 0;
  std::uint64_t recorded = 0;  ///< [ns]
  std::string_view data;
};
[[nodiscard]] McapMessage mcapMessage(std::string_view content);

/// The head of a chunk.
struct McapChunk {
  std::uint64_t size = 0;  ///< [byte] of its records, decompressed
  std::uint32_t checksum = 0;
  std::string compression;
  std::uint64_t place = 0;            ///< offset of its records in the file
  std::uint64_t compressed_size = 0;  ///< [byte]
};
/// @param start  the first bytes of the record's content, as many as a head may have
/// @param place  offset of the content in the file
/// @param length  of the whole content
[[nodiscard]] McapChunk mcapChunk(std::string_view start, std::uint64_t place,
                                  std::uint64_t length);
inline constexpr std::uint64_t kLongestMcapChunkHead = 8 + 8 + 8 + 4 + 4 + 64 + 8;  // [byte]

/// Decompresses the records of a chunk.
/// @throws Error if they are damaged, or larger than kLargestContent
[[nodiscard]] std::string mcapContent(const McapChunk& chunk, std::string_view compressed);

}  // namespace synthetic_dataset::motion
