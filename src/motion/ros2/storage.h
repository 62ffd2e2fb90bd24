#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// A topic as stored in a bag of ROS 2.
struct StoredTopic {
  std::string name;
  std::string type;        ///< "tf2_msgs/msg/TFMessage"
  std::string encoding;    ///< "cdr"
  std::string definition;  ///< of the type and all types in it, as .msg files; empty if not
                           ///< recorded
};

struct StoredMessage {
  Stamp recorded{0};
  std::uint32_t topic = 0;  ///< index in Storage::topics
  std::uint64_t place = 0;  ///< argument of Storage::read
};

/// The content of one file of a ROS 2 bag.
struct Storage {
  std::string kind;  ///< "sqlite3" or "mcap", with its compression
  std::vector<StoredTopic> topics;
  std::vector<StoredMessage> messages;  ///< in the order in which they were written
  std::string note;                     ///< what the user should know about it, or empty

  /// Reads a message's bytes. @throws Error if they are damaged
  std::function<std::string(std::uint64_t place)> read;
};

/// Largest decompressed size of a message or a chunk [byte].
inline constexpr std::uint64_t kLargestContent = std::uint64_t{1} << 30U;

/// @param nanoseconds  since the epoch
/// @throws Error for a time that ROS cannot represent: its messages count seconds in 32 bits
[[nodiscard]] Stamp recordTime(std::uint64_t nanoseconds);

/// Opens a file of rosbag2, decompressing it into a temporary file first if the whole file is
/// Zstandard-compressed (`--compression-mode file`).
/// @throws Error if it is not such a file, is damaged, or cannot be opened
[[nodiscard]] Storage openStorage(const std::string& file);

}  // namespace synthetic_dataset::motion
