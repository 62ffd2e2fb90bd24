// Recorded messages: a valid bag contains the input as the content of its messages.
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>

#include "fuzzing.h"
#include "motion/bag/checked_messages.h"
#include "motion/bag_motion.h"
#include "motion/recorded/recorded_camera_info.h"
#include "motion/recorded/recorded_map.h"
#include "scene/calibration/camera_info.h"

namespace {

/// The content of a message of a type.
template <class Message>
struct Content {
  std::string bytes;
};

using Transforms = Content<tf2_msgs::TFMessage>;
using Calibration = Content<sensor_msgs::CameraInfo>;
using Grid = Content<nav_msgs::OccupancyGrid>;
using Odometry = Content<nav_msgs::Odometry>;
using Joints = Content<sensor_msgs::JointState>;

}  // namespace

namespace ros {
namespace message_traits {
template <class Message>
struct MD5Sum<Content<Message>> : MD5Sum<Message> {
  static const char* value(const Content<Message>&) { return MD5Sum<Message>::value(); }
};
template <class Message>
struct DataType<Content<Message>> : DataType<Message> {
  static const char* value(const Content<Message>&) { return DataType<Message>::value(); }
};
template <class Message>
struct Definition<Content<Message>> : Definition<Message> {
  static const char* value(const Content<Message>&) { return Definition<Message>::value(); }
};
}  // namespace message_traits

namespace serialization {
template <class Message>
struct Serializer<Content<Message>> {
  template <class Stream>
  static void write(Stream& stream, const Content<Message>& content) {
    std::copy(content.bytes.begin(), content.bytes.end(),
              stream.advance(serializedLength(content)));
  }
  static std::uint32_t serializedLength(const Content<Message>& content) {
    return static_cast<std::uint32_t>(content.bytes.size());
  }
};
}  // namespace serialization
}  // namespace ros

namespace {

/// Topics that are read if there is no TF.
void readOtherTopics(const std::string& bytes) {
  using namespace synthetic_dataset;
  const std::string file = (fuzzing::folder() / "others.bag").string();
  {
    rosbag::Bag bag(file, rosbag::bagmode::Write);
    bag.write("/odom", ros::Time(5, 0), Odometry{bytes});
    bag.write("/joint_states", ros::Time(6, 0), Joints{bytes});
  }
  motion::JointedLink base;
  base.frame = "base";
  motion::JointedLink arm;
  arm.frame = "arm";
  arm.parent = 0;
  arm.joint = "shoulder";
  for (const bool has_robot : {false, true}) {
    motion::BagMotionOptions options;
    options.bag_files = {file};
    if (has_robot) {
      options.robots = [&] {
        return std::vector<motion::JointedRobot>{{"robot", "base", 0, {base, arm}}};
      };
    } else {
      options.frames = {"robot"};
    }
    fuzzing::tolerating([&] { const motion::BagMotion motion(options); });
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace synthetic_dataset;
  if (size == 0) return 0;
  const std::string bytes(fuzzing::view(data, size));
  const std::string file = (fuzzing::folder() / "messages.bag").string();
  {
    rosbag::Bag bag(file, rosbag::bagmode::Write);
    bag.write("/tf", ros::Time(5, 0), Transforms{bytes});
    bag.write("/camera_info", ros::Time(6, 0), Calibration{bytes});
    bag.write("/map", ros::Time(7, 0), Grid{bytes});
  }
  fuzzing::tolerating([&] {
    const auto camera = motion::readCameraInfo({file}, "/camera_info");
    static_cast<void>(scene::cameraOf(camera.info, "/camera_info", {false, 0.01, 100.0}));
  });
  fuzzing::tolerating([&] { static_cast<void>(motion::readMap({file}, "/map")); });
  fuzzing::tolerating([&] {
    base::Diagnostics found;
    motion::BagMotion({file}, "map").report({}, found);
  });
  readOtherTopics(bytes);
  return 0;
}
