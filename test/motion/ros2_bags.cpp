#include "motion/ros2_bags.h"

#include <lz4frame.h>
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <map>

#include "base/sqlite.h"

namespace synthetic_dataset::motion {
namespace {

constexpr std::size_t kHead = 4;

template <class Number>
std::string little(Number value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string sized(const std::string& text) {
  return little(static_cast<std::uint32_t>(text.size())) + text;
}

std::string record(unsigned char kind, const std::string& content) {
  return std::string(1, static_cast<char>(kind)) + little<std::uint64_t>(content.size()) + content;
}

std::string descriptions(const TestBag& bag) {
  std::string text;
  for (std::size_t i = 0; i < bag.topics.size(); ++i) {
    const TestTopic& topic = bag.topics[i];
    const auto id = static_cast<std::uint16_t>(i + 1);
    text +=
        record(0x03, little(id) + sized(topic.type) + sized("ros2msg") + sized(topic.definition));
    text += record(0x04,
                   little(id) + little(id) + sized(topic.name) + sized(topic.encoding) + sized(""));
  }
  return text;
}

std::string messageRecord(const TestMessage& message) {
  const auto time = little(static_cast<std::uint64_t>(message.recorded.count()));
  return record(0x05, little(static_cast<std::uint16_t>(message.topic + 1)) +
                          little(std::uint32_t{0}) + time + time + message.bytes);
}

std::string chunkOf(const std::string& content, const McapStyle& style) {
  const std::string packed = style.compression == "zstd"  ? zstdFrame(content)
                             : style.compression == "lz4" ? lz4Frame(content)
                                                          : content;
  const auto sum = static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size())));
  return record(0x06, std::string(16, '\0') + little<std::uint64_t>(content.size()) +
                          little(style.has_checksums ? sum : std::uint32_t{0}) +
                          sized(style.compression) + little<std::uint64_t>(packed.size()) + packed);
}

}  // namespace

const char* const kTransformsDefinition = R"(# frames
geometry_msgs/TransformStamped[] transforms
================================================================================
MSG: geometry_msgs/TransformStamped
std_msgs/Header header   # of the parent
string child_frame_id
Transform transform
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
================================================================================
MSG: geometry_msgs/Transform
Vector3 translation
Quaternion rotation
================================================================================
MSG: geometry_msgs/Vector3
float64 x
float64 y
float64 z
================================================================================
MSG: geometry_msgs/Quaternion
float64 x 0
float64 y 0
float64 z 0
float64 w 1
)";

CdrText::CdrText(Order order) : order_(order), text_(kHead, '\0') {
  text_[1] = order == Order::kLittle ? '\1' : '\0';
}

CdrText& CdrText::bytes(const void* value, std::size_t size) {
  while ((text_.size() - kHead) % size != 0) text_ += '\0';
  std::string number(static_cast<const char*>(value), size);
  if (order_ == Order::kBig) std::reverse(number.begin(), number.end());
  text_ += number;
  return *this;
}

CdrText& CdrText::text(std::string_view value) {
  number(static_cast<std::uint32_t>(value.size() + 1));
  text_ += value;
  text_ += '\0';
  return *this;
}

CdrText& CdrText::header(Stamp stamp, const std::string& frame) {
  constexpr std::int64_t kSecond = 1000000000;
  number(static_cast<std::int32_t>(stamp.count() / kSecond));
  number(static_cast<std::uint32_t>(stamp.count() % kSecond));
  return text(frame);
}

std::string cdrTransform(const std::string& parent, const std::string& child, Stamp stamp, double x,
                         CdrText::Order order) {
  CdrText cdr(order);
  cdr.number(std::uint32_t{1}).header(stamp, parent).text(child);
  for (const double each : {x, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}) cdr.number(each);
  return cdr.str();
}

TestBag drivingBag(std::size_t count) {
  TestBag bag;
  bag.topics.emplace_back();
  for (std::size_t i = 1; i <= count; ++i) {
    const Stamp time = std::chrono::seconds(i);
    bag.messages.push_back({0, time, cdrTransform("map", "robot", time, static_cast<double>(i))});
  }
  return bag;
}

std::string zstdFrame(std::string_view content) {
  std::string frame(ZSTD_compressBound(content.size()), '\0');
  frame.resize(ZSTD_compress(frame.data(), frame.size(), content.data(), content.size(), 3));
  return frame;
}

std::string lz4Frame(std::string_view content) {
  std::string frame(LZ4F_compressFrameBound(content.size(), nullptr), '\0');
  frame.resize(
      LZ4F_compressFrame(frame.data(), frame.size(), content.data(), content.size(), nullptr));
  return frame;
}

std::string mcapOf(const TestBag& bag, const McapStyle& style) {
  const std::string magic = "\x89MCAP0\r\n";
  std::string file = magic + record(0x01, sized("ros2") + sized("test"));
  if (style.chunk == 0) file += descriptions(bag);
  for (std::size_t i = 0; i < bag.messages.size();) {
    if (style.chunk == 0) {
      file += messageRecord(bag.messages[i++]);
      continue;
    }
    std::string content = i == 0 ? descriptions(bag) : "";
    std::map<std::uint16_t, std::string> indices;
    for (std::size_t n = 0; n < style.chunk && i < bag.messages.size(); ++n, ++i) {
      const TestMessage& message = bag.messages[i];
      indices[static_cast<std::uint16_t>(message.topic + 1)] +=
          little(static_cast<std::uint64_t>(message.recorded.count())) +
          little<std::uint64_t>(content.size());
      content += messageRecord(message);
    }
    file += chunkOf(content, style);
    if (!style.has_index) continue;
    for (const auto& [channel, entries] : indices) {
      file += record(0x07, little(channel) + sized(entries));
    }
  }
  file += record(0x0F, little(std::uint32_t{0}));
  const std::uint64_t summary = style.has_summary ? file.size() : 0;
  if (style.has_summary) file += descriptions(bag);
  return file +
         record(0x02, little(summary) + little(std::uint64_t{0}) + little(std::uint32_t{0})) +
         magic;
}

void writeSqlite(const std::filesystem::path& file, const TestBag& bag, SqliteVersion version) {
  const base::SqliteDatabase database(file.string(), base::SqliteDatabase::Mode::kCreate);
  const bool is_new = version == SqliteVersion::kIron;
  database.execute(std::string("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, "
                               "type TEXT NOT NULL, serialization_format TEXT NOT NULL") +
                   (is_new ? ", offered_qos_profiles TEXT, type_description_hash TEXT" : "") + ")");
  database.execute(
      "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, "
      "timestamp INTEGER NOT NULL, data BLOB NOT NULL);"
      "CREATE INDEX timestamp_idx ON messages (timestamp ASC);");
  base::SqliteStatement add_topic(
      database, "INSERT INTO topics (name, type, serialization_format) VALUES (?, ?, ?)");
  for (const TestTopic& topic : bag.topics) add_topic.run(topic.name, topic.type, topic.encoding);
  if (is_new) {
    database.execute(
        "CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT, encoding TEXT, "
        "encoded_message_definition TEXT, type_description_hash TEXT)");
    base::SqliteStatement define(database,
                                 "INSERT INTO message_definitions (topic_type, encoding, "
                                 "encoded_message_definition) VALUES (?, 'ros2msg', ?)");
    for (const TestTopic& topic : bag.topics) {
      if (!topic.definition.empty()) define.run(topic.type, topic.definition);
    }
  }
  base::SqliteStatement add(database,
                            "INSERT INTO messages (topic_id, timestamp, data) VALUES (?, ?, ?)");
  for (const TestMessage& message : bag.messages) {
    add.run(static_cast<std::int64_t>(message.topic + 1),
            static_cast<std::int64_t>(message.recorded.count()), base::Blob{message.bytes});
  }
}

std::string metadataOf(const std::vector<std::string>& files) {
  std::string text = "rosbag2_bagfile_information:\n  version: 9\n  relative_file_paths:\n";
  for (const std::string& file : files) text += "    - " + file + "\n";
  return text;
}

}  // namespace synthetic_dataset::motion
