#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// A topic as a bag of ROS 2 stores it.
struct StoredTopic {
  std::string name;
  std::string type;        ///< "tf2_msgs/msg/TFMessage"
  std::string encoding;    ///< "cdr"
  std::string definition;  ///< of the type and all types in it, as .msg files; empty: not recorded
};

struct StoredMessage {
  Stamp recorded{0};
  std::uint32_t topic = 0;  ///< index in Storage::topics
  std::uint64_t place = 0;  ///< for Storage::read
};

/// What one file of a bag of ROS 2 holds.
struct Storage {
  std::string kind;  ///< "sqlite3" or "mcap", with what compresses it
  std::vector<StoredTopic> topics;
  std::vector<StoredMessage> messages;  ///< in the order in which they were written
  std::string note;                     ///< what the user should know of it, or nothing

  /// A message's bytes. @throws Error where they are damaged
  std::function<std::string(std::uint64_t place)> read;
};

/// [byte] of a message, or of a chunk, when it is decompressed.
inline constexpr std::uint64_t kLargestContent = std::uint64_t{1} << 30U;

/// @param nanoseconds  since the epoch
/// @throws Error for a time that ROS cannot hold: its messages count seconds in 32 bits
[[nodiscard]] Stamp recordTime(std::uint64_t nanoseconds);

/// Opens a file of rosbag2, decompressing it into a temporary file first where it is a whole frame
/// of Zstandard (`--compression-mode file`).
/// @throws Error where it is no such file, is damaged, or cannot be opened
[[nodiscard]] Storage openStorage(const std::string& file);

}  // namespace synthetic_dataset::motion
