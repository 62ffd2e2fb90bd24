#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace synthetic_dataset::motion {

struct MessageLayout;

struct FieldLayout {
  enum class Count { kOne, kFixed, kList };

  std::string type;  ///< "float64", "string", or a message's: "geometry_msgs/Pose"
  std::string name;
  Count count = Count::kOne;
  std::uint32_t fixed_count = 1;
  std::size_t number_size = 0;                             ///< [byte] of a number; 0: not a number
  std::shared_ptr<const MessageLayout> message = nullptr;  ///< of a message
};

/// The fields of a message type, in order.
struct MessageLayout {
  std::string type;  ///< "geometry_msgs/Pose"
  std::vector<FieldLayout> fields;
  std::uint64_t least_size = 0;  ///< [byte], smallest size of a message
};

/// "tf2_msgs/msg/TFMessage" as ROS 1 spells it: "tf2_msgs/TFMessage".
[[nodiscard]] std::string ros1TypeOf(const std::string& ros2_type);

/// Reads the definition of a type in the form stored in bags: its .msg file, followed by those of
/// the types in it, each after lines of "=" and "MSG: package/Name"
/// (https://docs.ros.org/en/rolling/Concepts/Basic/About-Interfaces.html).
/// @param type  as ROS 1 spells it
/// @throws Error if it is not a definition, lacks a type, or a type contains itself
[[nodiscard]] std::shared_ptr<const MessageLayout> parseLayout(const std::string& type,
                                                               const std::string& definition);

/// The first difference of two layouts, "geometry_msgs/Pose has 'float32 x' for 'float64 x'"; empty
/// if there is none. Names may differ in case, as those of sensor_msgs/CameraInfo do in ROS 1.
[[nodiscard]] std::string differenceOf(const MessageLayout& found, const MessageLayout& known);

}  // namespace synthetic_dataset::motion
