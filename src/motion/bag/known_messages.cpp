#include "motion/bag/known_messages.h"

#include <map>

#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>

#include "motion/bag/checked_messages.h"

namespace synthetic_dataset::motion {
namespace {

/// The types that are read and all types in them, as ROS 2's packages define them since Dashing
/// (https://github.com/ros2/common_interfaces, rcl_interfaces and geometry2; gazebo_msgs of
/// https://github.com/ros-simulation/gazebo_ros_pkgs). The fields are those of ROS 1, except that
/// std_msgs/Header has an additional number in ROS 1.
constexpr const char* kDefinitions = R"(
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
====
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
====
MSG: std_msgs/String
string data
====
MSG: rosgraph_msgs/Clock
builtin_interfaces/Time clock
====
MSG: geometry_msgs/Point
float64 x
float64 y
float64 z
====
MSG: geometry_msgs/Vector3
float64 x
float64 y
float64 z
====
MSG: geometry_msgs/Quaternion
float64 x
float64 y
float64 z
float64 w
====
MSG: geometry_msgs/Pose
Point position
Quaternion orientation
====
MSG: geometry_msgs/PoseStamped
std_msgs/Header header
Pose pose
====
MSG: geometry_msgs/PoseArray
std_msgs/Header header
Pose[] poses
====
MSG: geometry_msgs/PoseWithCovariance
Pose pose
float64[36] covariance
====
MSG: geometry_msgs/PoseWithCovarianceStamped
std_msgs/Header header
PoseWithCovariance pose
====
MSG: geometry_msgs/Twist
Vector3 linear
Vector3 angular
====
MSG: geometry_msgs/TwistWithCovariance
Twist twist
float64[36] covariance
====
MSG: geometry_msgs/Transform
Vector3 translation
Quaternion rotation
====
MSG: geometry_msgs/TransformStamped
std_msgs/Header header
string child_frame_id
Transform transform
====
MSG: tf2_msgs/TFMessage
geometry_msgs/TransformStamped[] transforms
====
MSG: nav_msgs/Odometry
std_msgs/Header header
string child_frame_id
geometry_msgs/PoseWithCovariance pose
geometry_msgs/TwistWithCovariance twist
====
MSG: nav_msgs/Path
std_msgs/Header header
geometry_msgs/PoseStamped[] poses
====
MSG: nav_msgs/MapMetaData
builtin_interfaces/Time map_load_time
float32 resolution
uint32 width
uint32 height
geometry_msgs/Pose origin
====
MSG: nav_msgs/OccupancyGrid
std_msgs/Header header
MapMetaData info
int8[] data
====
MSG: sensor_msgs/JointState
std_msgs/Header header
string[] name
float64[] position
float64[] velocity
float64[] effort
====
MSG: sensor_msgs/RegionOfInterest
uint32 x_offset
uint32 y_offset
uint32 height
uint32 width
bool do_rectify
====
MSG: sensor_msgs/CameraInfo
std_msgs/Header header
uint32 height
uint32 width
string distortion_model
float64[] d
float64[9] k
float64[9] r
float64[12] p
uint32 binning_x
uint32 binning_y
RegionOfInterest roi
====
MSG: sensor_msgs/Image
std_msgs/Header header
uint32 height
uint32 width
string encoding
uint8 is_bigendian
uint32 step
uint8[] data
====
MSG: sensor_msgs/CompressedImage
std_msgs/Header header
string format
uint8[] data
====
MSG: sensor_msgs/PointField
string name
uint32 offset
uint8 datatype
uint32 count
====
MSG: sensor_msgs/PointCloud2
std_msgs/Header header
uint32 height
uint32 width
PointField[] fields
bool is_bigendian
uint32 point_step
uint32 row_step
uint8[] data
bool is_dense
====
MSG: gazebo_msgs/ModelStates
string[] name
geometry_msgs/Pose[] pose
geometry_msgs/Twist[] twist
====
MSG: gazebo_msgs/LinkStates
string[] name
geometry_msgs/Pose[] pose
geometry_msgs/Twist[] twist
)";

using KnownMessages = std::map<std::string, KnownMessage>;

template <class Message>
void add(const std::string& type, KnownMessages& messages) {
  // The definitions do not begin inside a type.
  messages[type] = {ros::message_traits::MD5Sum<Message>::value(),
                    parseLayout(type, std::string("====") + kDefinitions)};
}

template <class Message>
void add(KnownMessages& messages) {
  add<Message>(ros::message_traits::DataType<Message>::value(), messages);
}

KnownMessages makeKnownMessages() {
  KnownMessages messages;
  add<tf2_msgs::TFMessage>(messages);
  add<geometry_msgs::PoseArray>(messages);
  add<geometry_msgs::PoseStamped>(messages);
  add<geometry_msgs::PoseWithCovarianceStamped>(messages);
  add<geometry_msgs::TransformStamped>(messages);
  add<nav_msgs::OccupancyGrid>(messages);
  add<nav_msgs::Odometry>(messages);
  add<nav_msgs::Path>(messages);
  add<rosgraph_msgs::Clock>(messages);
  add<sensor_msgs::CameraInfo>(messages);
  add<sensor_msgs::CompressedImage>(messages);
  add<sensor_msgs::Image>(messages);
  add<sensor_msgs::JointState>(messages);
  add<sensor_msgs::PointCloud2>(messages);
  add<std_msgs::String>(messages);
  add<RecordedStates>(RecordedStates::kModelStates, messages);
  add<RecordedStates>(RecordedStates::kLinkStates, messages);
  return messages;
}

}  // namespace

const KnownMessage* knownMessage(const std::string& type) {
  static const KnownMessages kMessages = makeKnownMessages();
  const auto found = kMessages.find(type);
  return found == kMessages.end() ? nullptr : &found->second;
}

}  // namespace synthetic_dataset::motion
