// ROS 2 messages and the definitions of their types: the first byte selects the type, or says that
// the input is a definition.
#include <array>

#include "fuzzing.h"
#include "motion/bag/known_messages.h"
#include "motion/ros2/cdr.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace synthetic_dataset;
  static const std::array<const char*, 7> kTypes = {
      "tf2_msgs/TFMessage",         "sensor_msgs/CameraInfo", "sensor_msgs/JointState",
      "sensor_msgs/PointCloud2",    "nav_msgs/OccupancyGrid", "gazebo_msgs/LinkStates",
      "sensor_msgs/CompressedImage"};
  if (size == 0) return 0;
  const std::string input(fuzzing::view(data + 1, size - 1));
  const std::size_t choice = *data % (kTypes.size() + 1);
  fuzzing::tolerating([&] {
    if (choice < kTypes.size()) {
      static_cast<void>(
          motion::ros1Serialized(input, *motion::knownMessage(kTypes[choice])->layout));
      return;
    }
    const auto layout = motion::parseLayout("tf2_msgs/TFMessage", input);
    static_cast<void>(
        motion::differenceOf(*layout, *motion::knownMessage("tf2_msgs/TFMessage")->layout));
  });
  return 0;
}
