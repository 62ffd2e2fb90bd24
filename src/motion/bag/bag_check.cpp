#include "motion/bag/bag_check.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <rosbag/chunked_file.h>

#include "motion/bag/bag_records.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

/// Recorders write chunks of 768 KiB plus a message; librosbag's buffers are limited to 4 GiB.
constexpr std::uint64_t kLargestChunk = std::uint64_t{1} << 30U;
/// bzip2 compresses a block of 900,000 equal bytes to 40; LZ4's largest ratio is far smaller.
constexpr std::uint64_t kLargestRatio = 50000;

void require(const BagHeader& header, std::uint64_t operation, const std::string& what) {
  if (header.operation() != operation) throw Error("a record should be " + what + " and is not");
}

/// Moves past the message at the place; in version 1.2, its type's definition may precede it.
void passMessage(BagBytes& bytes, std::uint64_t place) {
  constexpr int kMostDefinitions = 16;
  bytes.goTo(place);
  BagHeader header = bytes.header();
  std::uint64_t length = bytes.number(4);
  for (int i = 0; i < kMostDefinitions && header.operation() == kMessageDefinition; ++i) {
    header = bytes.header();
    length = bytes.number(4);
  }
  require(header, kMessageData, "a message");
  bytes.skip(length);
}

/// Checks the messages at these places, none of which may end after `end`. Messages that overlapped
/// would turn a small file into a large recording.
void checkMessages(BagBytes& bytes, std::vector<std::uint64_t> places, std::uint64_t end) {
  std::sort(places.begin(), places.end());
  std::uint64_t free = 0;
  for (const std::uint64_t place : places) {
    if (place < free) throw Error("messages overlap");
    passMessage(bytes, place);
    free = bytes.place();
    if (free > end) throw Error("a message goes beyond its chunk");
  }
}

/// Decompresses into a buffer filled with 255, a byte that no record's header or length can consist
/// of.
std::string decompressed(const std::string& bytes, rosbag::CompressionType compression,
                         std::uint64_t size, char fill = '\xFF') {
  std::string source = bytes;
  std::string result(size, fill);
  try {
    rosbag::ChunkedFile().decompress(
        compression, reinterpret_cast<std::uint8_t*>(result.data()), static_cast<unsigned>(size),
        reinterpret_cast<std::uint8_t*>(source.data()), static_cast<unsigned>(source.size()));
  } catch (const rosbag::BagException& exception) {
    throw Error(std::string("a chunk cannot be decompressed: ") + exception.what());
  }
  return result;
}

/// Checks bags of version 2.0.
class Check {
 public:
  Check(BagBytes& file, const TopicFilter& is_read) : file_(file), is_read_(is_read) {}

  MessagePlaces run(const BagHeader& header) {
    if (header.has("encryptor") && !header.text("encryptor").empty() &&
        header.text("encryptor") != "rosbag/NoEncryptor") {
      throw EncryptedBag("is encrypted; `rosbag decrypt` makes a readable bag of it");
    }
    const std::uint64_t connections = header.number("conn_count", 4);
    const std::uint64_t chunks = header.number("chunk_count", 4);
    file_.goTo(header.number("index_pos", 8));
    for (std::uint64_t i = 0; i < connections; ++i) readConnection();
    for (std::uint64_t i = 0; i < chunks; ++i) readChunkInfo();
    std::sort(infos_.begin(), infos_.end(),
              [](const ChunkInfo& a, const ChunkInfo& b) { return a.place < b.place; });
    std::uint64_t free = 0;
    for (const ChunkInfo& info : infos_) {
      if (info.place < free) throw Error("chunks overlap");
      free = checkChunk(info);
      ++chunk_;
    }
    return sortedPlaces();
  }

 private:
  struct ChunkInfo {
    std::uint64_t place = 0;
    std::set<std::uint64_t> connections;
  };

  struct Chunk {
    std::string compression;
    std::uint64_t data = 0;  ///< offset of its content in the file
    std::uint64_t bytes = 0;
    std::uint64_t uncompressed_bytes = 0;
  };

  /// Sorts by record time, in the order in which librosbag returns messages; equal times stay in
  /// the order of the index.
  MessagePlaces sortedPlaces() {
    MessagePlaces sorted;
    for (auto& [connection, entries] : places_) {
      std::stable_sort(entries.begin(), entries.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first; });
      std::vector<MessagePlace>& places = sorted[connection];
      for (const auto& [time, place] : entries) places.push_back(place);
    }
    return sorted;
  }

  void readConnection() {
    const BagHeader header = file_.header();
    require(header, kConnection, "a connection");
    topics_.emplace(header.number("conn", 4), header.text("topic"));
    static_cast<void>(file_.header());  // the publisher's header
  }

  void readChunkInfo() {
    const BagHeader header = file_.header();
    require(header, kChunkInfo, "a chunk's header");
    ChunkInfo info;
    info.place = header.number("chunk_pos", 8);
    file_.skip(4);  // the data's length, which follows from the count
    const std::uint64_t count = header.number("count", 4);
    for (std::uint64_t i = 0; i < count; ++i) {
      info.connections.insert(file_.number(4));
      file_.skip(4);  // number of messages
    }
    infos_.push_back(std::move(info));
  }

  /// @return where the chunk ends, including its indices
  std::uint64_t checkChunk(const ChunkInfo& info) {
    file_.goTo(info.place);
    const BagHeader header = file_.header();
    require(header, kChunk, "a chunk");
    Chunk chunk;
    chunk.compression = header.text("compression");
    chunk.uncompressed_bytes = header.number("size", 4);
    chunk.bytes = file_.number(4);
    chunk.data = file_.place();
    file_.skip(chunk.bytes);
    std::vector<std::uint64_t> offsets;
    for (std::size_t i = 0; i < info.connections.size(); ++i) readIndex(offsets);
    const std::uint64_t end = file_.place();
    if (!offsets.empty()) checkContent(chunk, std::move(offsets));
    return end;
  }

  /// Adds the offsets of the messages that are going to be read.
  void readIndex(std::vector<std::uint64_t>& offsets) {
    const BagHeader header = file_.header();
    require(header, kIndexData, "an index");
    file_.skip(4);  // the data's length, which follows from the count
    const std::uint64_t connection = header.number("conn", 4);
    const auto topic = topics_.find(connection);
    if (topic == topics_.end()) throw Error("an index refers to a connection that does not exist");
    constexpr std::uint64_t kEntry = 12;  // [byte]: seconds, nanoseconds, offset
    const std::uint64_t count = header.number("count", 4);
    if (!is_read_(topic->second)) {
      file_.skip(kEntry * count);
      return;
    }
    const std::string entries = file_.take(kEntry * count);
    auto& places = places_[static_cast<std::uint32_t>(connection)];
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::string_view entry = std::string_view(entries).substr(kEntry * i, kEntry);
      offsets.push_back(littleEndian(entry.substr(8)));
      const std::uint64_t time =
          (littleEndian(entry.substr(0, 4)) << 32U) + littleEndian(entry.substr(4, 4));
      places.emplace_back(time, (chunk_ << 32U) + offsets.back());
    }
  }

  void checkContent(const Chunk& chunk, std::vector<std::uint64_t> offsets) {
    if (std::max(chunk.bytes, chunk.uncompressed_bytes) > kLargestChunk) {
      throw Error("a chunk has more than " + std::to_string(kLargestChunk >> 20U) + " MiB");
    }
    if (chunk.compression == "none") {
      for (std::uint64_t& offset : offsets) offset += chunk.data;
      checkMessages(file_, std::move(offsets), chunk.data + chunk.bytes);
    } else {
      const std::string content = contentOf(chunk);
      BagChunkBytes bytes(content);
      checkMessages(bytes, std::move(offsets), content.size());
    }
  }

  std::string contentOf(const Chunk& chunk) {
    if (chunk.uncompressed_bytes > kLargestRatio * chunk.bytes) {
      throw Error("a chunk is said to be " + std::to_string(chunk.uncompressed_bytes) +
                  " bytes when decompressed, more than can come from its " +
                  std::to_string(chunk.bytes));
    }
    const bool is_known = chunk.compression == "bz2" || chunk.compression == "lz4";
    if (!is_known) throw Error("a chunk has the compression '" + chunk.compression + "'");
    const auto compression =
        chunk.compression == "bz2" ? rosbag::compression::BZ2 : rosbag::compression::LZ4;
    file_.goTo(chunk.data);
    const std::string bytes = file_.take(chunk.bytes);
    std::string content = decompressed(bytes, compression, chunk.uncompressed_bytes);
    const bool may_be_short = !content.empty() && content.back() == '\xFF';
    if (may_be_short &&
        decompressed(bytes, compression, chunk.uncompressed_bytes, '\0').back() == '\0') {
      throw Error("a chunk holds less than it claims");
    }
    return content;
  }

  BagBytes& file_;
  const TopicFilter& is_read_;
  std::map<std::uint64_t, std::string> topics_;  ///< by connection
  std::vector<ChunkInfo> infos_;
  std::uint64_t chunk_ = 0;  ///< number of the chunk being read
  /// Record times and places of messages that are going to be read, by connection.
  std::map<std::uint32_t, std::vector<std::pair<std::uint64_t, MessagePlace>>> places_;
};

/// Checks bags of version 1.2 (http://wiki.ros.org/Bags/Format/1.2): messages lie in the file
/// itself, followed by an index for each topic.
class OldCheck {
 public:
  explicit OldCheck(BagBytes& file) : file_(file) {}

  void run(const BagHeader& header) {
    file_.goTo(header.number("index_pos", 8));
    while (file_.place() < file_.size()) readIndex();
    checkMessages(file_, std::move(places_), file_.size());
    for (const auto& [place, topic] : definitions_) {
      file_.goTo(place);
      const BagHeader definition = file_.header();
      require(definition, kMessageDefinition, "the definition of a type");
      if (definition.text("topic") == topic) continue;
      throw Error("a type definition is for another topic than its index");
    }
  }

 private:
  void readIndex() {
    const BagHeader index = file_.header();
    require(index, kIndexData, "an index");
    file_.skip(4);
    constexpr std::uint64_t kEntry = 16;  // [byte]: seconds, nanoseconds, place
    const std::string entries = file_.take(kEntry * index.number("count", 4));
    std::map<std::uint64_t, std::uint64_t> place_at;  // the first of each time, as in librosbag
    for (std::size_t at = 0; at < entries.size(); at += kEntry) {
      const std::string_view entry = std::string_view(entries).substr(at, kEntry);
      constexpr std::uint64_t kSecond = 1000000000;  // [ns]
      const std::uint64_t time =
          littleEndian(entry.substr(0, 4)) * kSecond + littleEndian(entry.substr(4, 4));
      places_.push_back(littleEndian(entry.substr(8)));
      if (time > 0) place_at.emplace(time, places_.back());
    }
    if (place_at.empty()) throw Error("an index has no message with a time");
    definitions_.emplace_back(place_at.begin()->second, index.text("topic"));
  }

  BagBytes& file_;
  std::vector<std::uint64_t> places_;                               ///< of messages
  std::vector<std::pair<std::uint64_t, std::string>> definitions_;  ///< their places and topics
};

}  // namespace

MessagePlaces checkBag(const std::string& file, const TopicFilter& is_read) {
  BagFileBytes bytes(file);
  const std::string version = bytes.take(std::min<std::uint64_t>(bytes.size(), 13));
  const bool is_old = version == "#ROSBAG V1.2\n";
  if (!is_old && version != "#ROSBAG V2.0\n") throw Error("its first line is damaged");
  const BagHeader header = bytes.header();
  require(header, kFileHeader, "the file's header");
  if (header.number("index_pos", 8) == 0) return {};  // there is no index
  if (!is_old) return Check(bytes, is_read).run(header);
  OldCheck(bytes).run(header);
  return {};
}

}  // namespace synthetic_dataset::motion
