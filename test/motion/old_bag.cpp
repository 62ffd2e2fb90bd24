#include "motion/old_bag.h"

#include <cstdint>
#include <utility>
#include <vector>

#include <ros/serialization.h>
#include <tf2_msgs/TFMessage.h>

namespace synthetic_dataset::motion {
namespace {

using Fields = std::vector<std::pair<std::string, std::string>>;

template <class T>
std::string bytes(T number) {  // little-endian, as all machines that run ROS are
  return {reinterpret_cast<const char*>(&number), sizeof(number)};
}

std::string sized(const std::string& text) {
  return bytes(static_cast<std::uint32_t>(text.size())) + text;
}

std::string makeRecord(char op, const Fields& fields, const std::string& data) {
  std::string header = sized(std::string("op=") + op);
  for (const auto& [name, value] : fields) header += sized(name + "=" + value);
  return sized(header) + sized(data);
}

std::string serialized(const tf2_msgs::TFMessage& message) {
  std::string data(ros::serialization::serializationLength(message), '\0');
  ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(data.data()),
                                     static_cast<std::uint32_t>(data.size()));
  ros::serialization::serialize(stream, message);
  return data;
}

}  // namespace

std::string oldBag(const std::string& parent, const std::string& child, Stamp stamp, double x) {
  using Traits = ros::message_traits::MD5Sum<tf2_msgs::TFMessage>;
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(stamp);
  const auto sec = static_cast<std::uint32_t>(seconds.count());
  const auto nsec = static_cast<std::uint32_t>((stamp - seconds).count());
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  message.transforms[0].header.frame_id = parent;
  message.transforms[0].header.stamp = ros::Time(sec, nsec);
  message.transforms[0].child_frame_id = child;
  message.transforms[0].transform.translation.x = x;
  message.transforms[0].transform.rotation.w = 1.0;

  const Fields type = {{"topic", "/tf"}, {"md5", Traits::value()}, {"type", "tf/tfMessage"}};
  Fields definition = type;
  definition.emplace_back("def", "");
  Fields time = type;
  time.emplace_back("sec", bytes(sec));
  time.emplace_back("nsec", bytes(nsec));

  const std::string start = "#ROSBAG V1.2\n";
  const auto fileHeader = [](std::uint64_t index_position) {
    return makeRecord('\x03', {{"index_pos", bytes(index_position)}}, std::string(64, ' '));
  };
  const std::string messages =
      makeRecord('\x01', definition, "") + makeRecord('\x02', time, serialized(message));
  const std::uint64_t message_position = start.size() + fileHeader(0).size();
  const Fields index = {{"topic", "/tf"},
                        {"type", "tf/tfMessage"},
                        {"ver", bytes(std::uint32_t{0})},
                        {"count", bytes(std::uint32_t{1})}};
  return start + fileHeader(message_position + messages.size()) + messages +
         makeRecord('\x04', index, bytes(sec) + bytes(nsec) + bytes(message_position));
}

}  // namespace synthetic_dataset::motion
