#include "motion/ros2/mcap_records.h"

#include <zlib.h>

#include "motion/ros2/decompression.h"
#include "motion/ros2/storage.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

std::uint32_t checksumOf(std::string_view bytes) {
  constexpr std::size_t kAtOnce = std::size_t{1} << 30U;  // zlib's lengths have 32 bits
  uLong sum = crc32(0, nullptr, 0);
  while (!bytes.empty()) {
    const std::string_view part = bytes.substr(0, kAtOnce);
    sum = crc32(sum, reinterpret_cast<const Bytef*>(part.data()), static_cast<uInt>(part.size()));
    bytes.remove_prefix(part.size());
  }
  return static_cast<std::uint32_t>(sum);
}

}  // namespace

std::string_view McapBytes::take(std::uint64_t count) {
  if (count > rest_.size()) throw Error("a record is shorter than it should be");
  const std::string_view taken = rest_.substr(0, count);
  rest_.remove_prefix(count);
  return taken;
}

McapSchema mcapSchema(std::string_view content) {
  McapBytes bytes(content);
  McapSchema schema;
  schema.id = bytes.number<std::uint16_t>();
  schema.name = bytes.text();
  schema.encoding = bytes.text();
  schema.text = bytes.text();
  return schema;
}

McapChannel mcapChannel(std::string_view content) {
  McapBytes bytes(content);
  McapChannel channel;
  channel.id = bytes.number<std::uint16_t>();
  channel.schema = bytes.number<std::uint16_t>();
  channel.topic = bytes.text();
  channel.encoding = bytes.text();
  return channel;
}

McapMessage mcapMessage(std::string_view content) {
  McapBytes bytes(content);
  McapMessage message;
  message.channel = bytes.number<std::uint16_t>();
  (void)bytes.number<std::uint32_t>();  // sequence number
  message.recorded = bytes.number<std::uint64_t>();
  (void)bytes.number<std::uint64_t>();  // publish time
  message.data = bytes.rest();
  return message;
}

McapChunk mcapChunk(std::string_view start, std::uint64_t place, std::uint64_t length) {
  McapBytes bytes(start);
  McapChunk chunk;
  (void)bytes.take(8 + 8);  // record times of its first and last message
  chunk.size = bytes.number<std::uint64_t>();
  chunk.checksum = bytes.number<std::uint32_t>();
  chunk.compression = bytes.text();
  chunk.compressed_size = bytes.number<std::uint64_t>();
  const std::uint64_t head = start.size() - bytes.rest().size();
  if (chunk.compressed_size > length - head) throw Error("a chunk is longer than its record");
  chunk.place = place + head;
  return chunk;
}

std::string mcapContent(const McapChunk& chunk, std::string_view compressed) {
  if (chunk.size > kLargestContent) {
    throw Error("a chunk has more than " + std::to_string(kLargestContent >> 20U) + " MiB");
  }
  std::string content;
  if (chunk.compression.empty()) {
    content = compressed;
  } else if (chunk.size == 0) {
    content.clear();  // lz4 writes no frame for it
  } else if (chunk.compression == "zstd") {
    content = zstdDecompressed(compressed);
  } else if (chunk.compression == "lz4") {
    content = lz4Decompressed(compressed);
  } else {
    throw Error("a chunk has the compression '" + chunk.compression +
                "'; lz4, zstd and none can be read");
  }
  if (content.size() != chunk.size) {
    throw Error("a chunk has " + std::to_string(content.size()) + " bytes; it should have " +
                std::to_string(chunk.size));
  }
  if (chunk.checksum != 0 && chunk.checksum != checksumOf(content)) {
    throw Error("a chunk's content does not have its checksum");
  }
  return content;
}

}  // namespace synthetic_dataset::motion
