#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "synthetic_dataset/pose.h"

/// Small bags of ROS 2, byte by byte.
namespace synthetic_dataset::motion {

/// Serializes a message as CDR (encoding version 1).
class CdrText {
 public:
  enum class Order { kLittle, kBig };

  explicit CdrText(Order order = Order::kLittle);

  template <class Number>
  CdrText& number(Number value) {
    return bytes(&value, sizeof value);
  }
  CdrText& text(std::string_view value);
  /// A std_msgs/Header.
  CdrText& header(Stamp stamp, const std::string& frame);

  /// The message with its encapsulation header of four bytes.
  [[nodiscard]] const std::string& str() const { return text_; }

 private:
  CdrText& bytes(const void* value, std::size_t size);

  Order order_;
  std::string text_;
};

/// A tf2_msgs/msg/TFMessage with one transform along x [m].
[[nodiscard]] std::string cdrTransform(const std::string& parent, const std::string& child,
                                       Stamp stamp, double x,
                                       CdrText::Order order = CdrText::Order::kLittle);

/// The definition of tf2_msgs/msg/TFMessage, in the form used in bags.
extern const char* const kTransformsDefinition;

struct TestTopic {
  std::string name = "/tf";
  std::string type = "tf2_msgs/msg/TFMessage";
  std::string encoding = "cdr";
  std::string definition = {};
};

struct TestMessage {
  std::size_t topic = 0;
  Stamp recorded{0};
  std::string bytes;
};

struct TestBag {
  std::vector<TestTopic> topics;
  std::vector<TestMessage> messages;
};

/// "map" to "robot", at 1 s, 2 s, ..., moving by 1 m each.
[[nodiscard]] TestBag drivingBag(std::size_t count = 3);

[[nodiscard]] std::string zstdFrame(std::string_view content);
[[nodiscard]] std::string lz4Frame(std::string_view content);

struct McapStyle {
  std::size_t chunk = 2;         ///< messages per chunk; 0: no chunks
  std::string compression = {};  ///< "lz4" or "zstd"
  bool has_index = true;
  bool has_summary = true;  ///< if not, the file ends after the data
  bool has_checksums = true;
};
[[nodiscard]] std::string mcapOf(const TestBag& bag, const McapStyle& style = {});

enum class SqliteVersion { kDashing, kIron };
/// A database with the tables of a version of rosbag2.
void writeSqlite(const std::filesystem::path& file, const TestBag& bag,
                 SqliteVersion version = SqliteVersion::kIron);

/// A metadata.yaml that names these files.
[[nodiscard]] std::string metadataOf(const std::vector<std::string>& files);

}  // namespace synthetic_dataset::motion
