#include "motion/ros2/mcap_storage.h"

#include <algorithm>
#include <cstddef>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "motion/ros2/file_window.h"
#include "motion/ros2/mcap_records.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

/// A flag in a message's place: the other bits are its record's offset in the file. Without it, the
/// place consists of the number of the message's chunk and its record's offset in that chunk.
constexpr std::uint64_t kInFile = std::uint64_t{1} << 63U;

struct Record {
  McapRecord kind{};
  std::uint64_t place = 0;   ///< offset of its content
  std::uint64_t length = 0;  ///< [byte] of its content

  [[nodiscard]] std::uint64_t end() const { return place + length; }
};

Record recordAt(std::string_view head, std::uint64_t place) {
  McapBytes bytes(head);
  const auto kind = static_cast<McapRecord>(bytes.number<std::uint8_t>());
  return {kind, place + kMcapRecordHead, bytes.number<std::uint64_t>()};
}

/// Passes each record in the bytes to `see`.
template <class See>
void eachRecord(std::string_view bytes, const See& see) {
  for (std::uint64_t place = 0; place < bytes.size();) {
    if (bytes.size() - place < kMcapRecordHead) throw Error("a record of a chunk breaks off");
    const Record record = recordAt(bytes.substr(place, kMcapRecordHead), place);
    if (record.length > bytes.size() - record.place) throw Error("a record goes beyond its chunk");
    see(place, record.kind, bytes.substr(record.place, record.length));
    place = record.end();
  }
}

/// @param place  offset of a message's record
McapMessage messageAt(std::string_view content, std::uint64_t place) {
  const Record record = recordAt(content.substr(place, kMcapRecordHead), place);
  return mcapMessage(content.substr(record.place, record.length));
}

/// A chunk's content, and the offsets of its messages' records.
struct Loaded {
  std::size_t chunk;
  std::string content;
  std::vector<std::uint64_t> messages;  ///< in order
};

/// A chunk that the scan has passed, with the entries of its indices.
struct Passed {
  bool has_index = false;
  std::map<std::uint64_t, std::pair<std::uint16_t, std::uint64_t>> messages;  ///< by offset
};

class McapFile {
 public:
  explicit McapFile(const std::string& file) : file_(file) {}

  /// Notes the file's topics and messages.
  void scan(Storage& storage) {
    storage_ = &storage;
    readSummary();
    std::uint64_t place = kMcapMagic.size();
    bool is_whole = false;
    while (!is_whole && file_.size() - place >= kMcapRecordHead) {
      const Record record = recordAt(file_.at(place, kMcapRecordHead), place);
      if (record.length > file_.size() - record.place) break;
      is_whole = record.kind == McapRecord::kDataEnd || record.kind == McapRecord::kFooter;
      take(record);
      place = record.end();
    }
    if (!is_whole && chunk_) chunk_->has_index = false;  // it may be incomplete
    finishChunk();
    if (!is_whole) {
      storage.note = "breaks off after " + std::to_string(storage.messages.size()) +
                     " messages, at byte " + std::to_string(place) + ": what comes before is read";
    }
    storage.kind = "mcap";
    for (const std::string& compression : compressions_) storage.kind += ", " + compression;
    storage_ = nullptr;
  }

  std::string read(std::uint64_t place) {
    if ((place & kInFile) != 0) {
      const Record record = recordAt(file_.at(place & ~kInFile, kMcapRecordHead), place & ~kInFile);
      return std::string(mcapMessage(file_.at(record.place, record.length)).data);
    }
    const Loaded& chunk = loaded(place >> 32U);
    const std::uint64_t offset = place & 0xFFFFFFFFU;
    if (!std::binary_search(chunk.messages.begin(), chunk.messages.end(), offset)) {
      throw Error("its index points to something other than a message");
    }
    return std::string(messageAt(chunk.content, offset).data);
  }

 private:
  /// Reads the schemas and channels that may be repeated after the data.
  void readSummary() {
    constexpr std::uint64_t kFooter = kMcapRecordHead + 8 + 8 + 4;
    const std::uint64_t size = file_.size();
    if (size < 2 * kMcapMagic.size() + kFooter) return;
    if (file_.at(size - kMcapMagic.size(), kMcapMagic.size()) != kMcapMagic) return;
    const std::uint64_t footer = size - kMcapMagic.size() - kFooter;
    McapBytes bytes(file_.at(footer, kFooter));
    if (static_cast<McapRecord>(bytes.number<std::uint8_t>()) != McapRecord::kFooter) return;
    (void)bytes.number<std::uint64_t>();
    auto place = bytes.number<std::uint64_t>();
    if (place < kMcapMagic.size()) return;  // there is no summary
    while (place < footer && footer - place >= kMcapRecordHead) {
      const Record record = recordAt(file_.at(place, kMcapRecordHead), place);
      if (record.length > footer - record.place) return;
      if (isDescription(record.kind)) describe(record.kind, file_.at(record.place, record.length));
      place = record.end();
    }
  }

  static bool isDescription(McapRecord kind) {
    return kind == McapRecord::kSchema || kind == McapRecord::kChannel;
  }

  void describe(McapRecord kind, std::string_view content) {
    if (storage_ == nullptr) return;  // after the scan, everything is described
    if (kind == McapRecord::kSchema) {
      McapSchema schema = mcapSchema(content);
      schemas_.emplace(schema.id, std::move(schema));
      return;
    }
    const McapChannel channel = mcapChannel(content);
    if (topic_of_.count(channel.id) != 0) return;
    StoredTopic topic{channel.topic, "", channel.encoding, ""};
    const auto schema = schemas_.find(channel.schema);
    if (channel.schema != 0 && schema == schemas_.end()) {
      throw Error("the channel of '" + channel.topic + "' has a schema that does not exist");
    }
    if (schema != schemas_.end()) {
      topic.type = schema->second.name;
      if (schema->second.encoding == "ros2msg") topic.definition = schema->second.text;
    }
    topic_of_[channel.id] = static_cast<std::uint32_t>(storage_->topics.size());
    storage_->topics.push_back(std::move(topic));
  }

  void take(const Record& record) {
    if (record.kind != McapRecord::kMessageIndex) finishChunk();
    switch (record.kind) {
      case McapRecord::kSchema:
      case McapRecord::kChannel:
        describe(record.kind, file_.at(record.place, record.length));
        break;
      case McapRecord::kMessage: {
        const auto head = std::min<std::uint64_t>(record.length, McapMessage::kHead);
        const McapMessage message = mcapMessage(file_.at(record.place, head));
        note(message.channel, message.recorded, kInFile | (record.place - kMcapRecordHead));
        break;
      }
      case McapRecord::kChunk: {
        const auto head = std::min(record.length, kLongestMcapChunkHead);
        chunks_.push_back(mcapChunk(file_.at(record.place, head), record.place, record.length));
        if (!chunks_.back().compression.empty()) compressions_.insert(chunks_.back().compression);
        chunk_.emplace();
        break;
      }
      case McapRecord::kMessageIndex:
        takeIndex(file_.at(record.place, record.length));
        break;
      default:
        break;
    }
  }

  void takeIndex(std::string_view content) {
    if (!chunk_) throw Error("an index of messages does not follow a chunk");
    chunk_->has_index = true;
    McapBytes bytes(content);
    const auto channel = bytes.number<std::uint16_t>();
    McapBytes entries(bytes.text());
    while (!entries.rest().empty()) {
      const auto recorded = entries.number<std::uint64_t>();
      const auto offset = entries.number<std::uint64_t>();
      // Messages that overlapped would turn a small file into a large recording.
      const bool is_new = chunk_->messages.emplace(offset, std::pair(channel, recorded)).second;
      if (!is_new || offset >= chunks_.back().size) {
        throw Error("an index of messages does not fit its chunk");
      }
    }
  }

  /// Notes the messages of the chunk that was passed, in their order.
  void finishChunk() {
    if (!chunk_) return;
    const Passed passed = *std::exchange(chunk_, std::nullopt);
    const std::uint64_t number = chunks_.size() - 1;
    const auto isKnown = [&](const auto& each) { return topic_of_.count(each.second.first) != 0; };
    if (chunks_.back().size > kLargestContent || !passed.has_index ||
        !std::all_of(passed.messages.begin(), passed.messages.end(), isKnown)) {
      (void)loaded(number);  // describes its channels
    }
    if (passed.has_index) {
      for (const auto& [offset, message] : passed.messages) {
        note(message.first, message.second, (number << 32U) + offset);
      }
      return;
    }
    const Loaded& chunk = loaded(number);
    for (const std::uint64_t offset : chunk.messages) {
      const McapMessage message = messageAt(chunk.content, offset);
      note(message.channel, message.recorded, (number << 32U) + offset);
    }
  }

  void note(std::uint16_t channel, std::uint64_t recorded, std::uint64_t place) {
    const auto topic = topic_of_.find(channel);
    if (topic == topic_of_.end()) throw Error("a message refers to a channel that does not exist");
    storage_->messages.push_back({recordTime(recorded), topic->second, place});
  }

  /// Keeps the last few chunks, as messages that were recorded late may be in an earlier one.
  const Loaded& loaded(std::size_t number) {
    const auto kept = std::find_if(loaded_.begin(), loaded_.end(),
                                   [&](const Loaded& each) { return each.chunk == number; });
    if (kept != loaded_.end()) {
      loaded_.splice(loaded_.begin(), loaded_, kept);
      return loaded_.front();
    }
    constexpr std::size_t kMostKept = 4;
    constexpr std::size_t kMostBytes = std::size_t{64} << 20U;
    const McapChunk& chunk = chunks_.at(number);
    std::size_t bytes = chunk.size;
    for (const Loaded& each : loaded_) bytes += each.content.size();
    while (!loaded_.empty() && (loaded_.size() >= kMostKept || bytes > kMostBytes)) {
      bytes -= loaded_.back().content.size();
      loaded_.pop_back();
    }
    Loaded fresh{number, mcapContent(chunk, file_.at(chunk.place, chunk.compressed_size)), {}};
    eachRecord(fresh.content, [&](std::uint64_t place, McapRecord kind, std::string_view content) {
      if (isDescription(kind)) describe(kind, content);
      if (kind == McapRecord::kMessage) fresh.messages.push_back(place);
    });
    loaded_.push_front(std::move(fresh));
    return loaded_.front();
  }

  FileWindow file_;
  Storage* storage_ = nullptr;  ///< during the scan
  std::map<std::uint16_t, McapSchema> schemas_;
  std::map<std::uint16_t, std::uint32_t> topic_of_;  ///< by channel
  std::vector<McapChunk> chunks_;
  std::optional<Passed> chunk_;  ///< the last of chunks_, while its indices are read
  std::set<std::string> compressions_;
  std::list<Loaded> loaded_;  ///< most recently used first
};

}  // namespace

bool isMcap(std::string_view start) { return start.substr(0, kMcapMagic.size()) == kMcapMagic; }

Storage openMcap(const std::string& file) {
  const auto reader = std::make_shared<McapFile>(file);
  Storage storage;
  reader->scan(storage);
  storage.read = [reader](std::uint64_t place) { return reader->read(place); };
  return storage;
}

}  // namespace synthetic_dataset::motion
