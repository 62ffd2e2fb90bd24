#include <algorithm>
#include <map>
#include <utility>

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <opencv2/imgcodecs.hpp>

#include "plugins/readback/camera_drawing.h"
#include "plugins/readback/cuboid_lines.h"
#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "plugins/ros_bag/bag_scene.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::ros_bag {
namespace {

namespace fs = std::filesystem;
using visualization_msgs::Marker;

class OpenBag {
 public:
  explicit OpenBag(const fs::path& file) : file_(file) {
    bag_.open(file.string(), rosbag::bagmode::Read);
    std::map<std::uint32_t, std::string> topics;  // in the order of their first messages
    for (const rosbag::ConnectionInfo* each : rosbag::View(bag_).getConnections()) {
      topics[each->id] = each->topic;
    }
    const std::string end = "/objects";
    for (const auto& [id, topic] : topics) {
      const std::size_t length = topic.size() - std::min(topic.size(), end.size());
      if (topic.substr(length) == end) roots_.push_back(topic.substr(0, length));
    }
  }

  /// The common prefix of a camera's topics, before `/objects` and others.
  [[nodiscard]] const std::string& rootOf(std::size_t camera) const {
    if (camera < roots_.size()) return roots_[camera];
    throw Error("'" + file_.string() + "': found the topics of " + std::to_string(roots_.size()) +
                " cameras; it should have more");
  }

  /// @throws Error if there is none
  template <class Message>
  [[nodiscard]] Message at(const std::string& topic, const ros::Time& time) const {
    for (const rosbag::MessageInstance& each :
         rosbag::View(bag_, rosbag::TopicQuery(topic), time, time)) {
      if (const auto message = each.instantiate<Message>()) return *message;
    }
    throw Error("'" + file_.string() + "': no message of '" + topic + "' at " +
                std::to_string(time.toNSec()) + " ns");
  }

  /// The poses at a time.
  [[nodiscard]] std::vector<geometry_msgs::TransformStamped> transforms(
      const ros::Time& time) const {
    std::vector<geometry_msgs::TransformStamped> all;
    for (const rosbag::MessageInstance& each :
         rosbag::View(bag_, rosbag::TopicQuery("/tf"), time, time)) {
      const auto message = each.instantiate<tf2_msgs::TFMessage>();
      if (message) all.insert(all.end(), message->transforms.begin(), message->transforms.end());
    }
    return all;
  }

 private:
  fs::path file_;
  rosbag::Bag bag_;
  std::vector<std::string> roots_;  ///< by camera
};

fs::path bagIn(const fs::path& folder) {
  std::vector<fs::path> bags;
  std::error_code error;  // a missing folder has no files
  for (fs::directory_iterator each(folder, error), end; !error && each != end;
       each.increment(error)) {
    if (each->path().extension() == ".bag") bags.push_back(each->path());
  }
  if (bags.empty()) {
    throw Error("'" + folder.string() +
                "': no bag is there; only a bag says what the numbers in the " +
                "pictures of instances mean (a run that was stopped leaves none)");
  }
  return *std::min_element(bags.begin(), bags.end());
}

template <class Point, class Quaternion>
Pose poseOf(const Point& p, const Quaternion& q) {
  return makePose({p.x, p.y, p.z}, Eigen::Quaterniond(q.w, q.x, q.y, q.z));
}

CameraModel cameraOf(const sensor_msgs::CameraInfo& info) {
  constexpr double kNear = 1e-3;  // a bag has no near and far limits
  constexpr double kFar = 1e6;
  return {static_cast<int>(info.width),
          static_cast<int>(info.height),
          {info.K[0], info.K[4], info.K[2], info.K[5]},
          kNear,
          kFar,
          makeDistortion(info.distortion_model, info.D)};
}

/// @param instances  CV_16UC1: the markers' ids
std::vector<DrawnLabel> labelsOf(const OpenBag& bag, const std::string& root, const ros::Time& time,
                                 const cv::Mat& instances) {
  const auto info = bag.at<sensor_msgs::CameraInfo>(root + "/camera_info", time);
  const CameraModel camera = cameraOf(info);
  Pose X_GC = Pose::Identity();  // if the camera's frame is the global one
  for (const geometry_msgs::TransformStamped& each : bag.transforms(time)) {
    if (each.child_frame_id != info.header.frame_id) continue;
    X_GC = poseOf(each.transform.translation, each.transform.rotation);
  }
  const auto markers = bag.at<visualization_msgs::MarkerArray>(root + "/objects", time).markers;
  std::vector<DrawnLabel> labels;
  for (const Marker& box : markers) {
    if (box.type != Marker::CUBE || box.action != Marker::ADD) continue;
    DrawnLabel label;
    label.caption = box.ns;
    label.class_names = {box.ns};
    for (const Marker& name : markers) {
      if (name.type == Marker::TEXT_VIEW_FACING && name.id == box.id) label.object_name = name.text;
    }
    label.mask = instances == box.id;
    const Eigen::Vector3d corner(0.5 * box.scale.x, 0.5 * box.scale.y, 0.5 * box.scale.z);
    label.lines =
        cuboidLines({-corner, corner},
                    X_GC.inverse() * poseOf(box.pose.position, box.pose.orientation), camera);
    labels.push_back(std::move(label));
  }
  return labels;
}

// Pictures are beside the bag; the bag contains the boxes and their objects' names, numbered like
// the pixels in instance pictures.
LabelledPicture readScene(const WrittenScene& scene) {
  LabelledPicture picture{
      readPicture(scene.file("images/" + scene.name + ".png"), cv::IMREAD_COLOR), {}};
  const fs::path file = scene.file("instances/" + scene.name + ".png");
  const cv::Mat instances = readPicture(file, cv::IMREAD_UNCHANGED);
  if (instances.type() != CV_16UC1) {
    throw Error("'" + file.string() + "': it should have one channel of 16 bits");
  }
  const fs::path bag_file = bagIn(scene.folder);
  try {
    const auto bag = scene.kept->get<OpenBag>(bag_file);
    const ros::Time time = ros::Time().fromNSec(static_cast<std::uint64_t>(scene.stamp.count()));
    picture.labels = labelsOf(*bag, bag->rootOf(scene.camera_index), time, instances);
  } catch (const rosbag::BagException& error) {
    throw Error("'" + bag_file.string() + "': " + error.what());
  }
  return picture;
}

/// The offset of a field within a point's bytes.
std::size_t offsetOf(const sensor_msgs::PointCloud2& message, const char* field,
                     const fs::path& file) {
  for (const sensor_msgs::PointField& each : message.fields) {
    if (each.name == field && each.offset + 4 <= message.point_step) return each.offset;
  }
  throw Error("'" + file.string() + "': its points have no field '" + field + "'");
}

sensor_msgs::PointCloud2 readCloudMessage(const fs::path& file) {
  try {
    return cloudIn(readText(file));
  } catch (const ros::serialization::StreamOverrunException& error) {
    throw Error("'" + file.string() + "': " + error.what());
  }
}

/// The measured points, with the numbers of their classes and objects.
LabelledCloud pointsOf(const sensor_msgs::PointCloud2& message, const fs::path& file) {
  LabelledCloud cloud;
  cloud.has_rings = cloud.has_labels = true;
  cloud.rays = std::int64_t{message.width} * message.height;
  const std::string bytes(message.data.begin(), message.data.end());
  const std::size_t x = offsetOf(message, "x", file);
  const std::size_t ring = offsetOf(message, "ring", file);
  const std::size_t label = offsetOf(message, "label", file);
  const std::size_t instance = offsetOf(message, "instance", file);
  const auto half = [&](std::size_t at) {
    return static_cast<std::uint16_t>(wordAt(bytes, at) & 0xFFFFU);
  };
  for (std::size_t at = 0; at + message.point_step <= bytes.size(); at += message.point_step) {
    LabelledCloud::Point point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point.position_S[static_cast<Eigen::Index>(axis)] = floatAt(bytes, at + x + 4 * axis);
    }
    if (!point.position_S.allFinite()) continue;
    point.ring = half(at + ring);
    point.number = half(at + label);
    point.object = half(at + instance);
    cloud.points.push_back(point);
  }
  return cloud;
}

/// Adds the boxes and names of objects, which the bag contains for those that the camera sees.
void addObjects(LabelledCloud& cloud, const std::vector<Marker>& markers, const Pose& X_GS) {
  for (const Marker& box : markers) {
    if (box.type != Marker::CUBE || box.action != Marker::ADD) continue;
    const auto number = static_cast<std::uint16_t>(box.id);
    LabelledCloud::Object& object = cloud.objects[number];
    object.class_name = box.ns;
    object.caption = box.ns + " " + std::to_string(box.id);
    const Eigen::Vector3d corner(0.5 * box.scale.x, 0.5 * box.scale.y, 0.5 * box.scale.z);
    const Pose X_SB = X_GS.inverse() * poseOf(box.pose.position, box.pose.orientation);
    object.corners_S = Cuboid{-corner, corner}.corners();
    for (Eigen::Vector3d& each : *object.corners_S) each = X_SB * each;
  }
  for (const LabelledCloud::Point& point : cloud.points) {
    const auto object = cloud.objects.find(point.object);
    if (object != cloud.objects.end()) cloud.classes[point.number] = object->second.class_name;
  }
}

std::vector<LabelledCloud> cloudsOf(const WrittenScene& scene) {
  std::vector<LabelledCloud> clouds;
  for (const fs::path& file : scene.files) {
    if (file.extension() != ".msg") continue;
    const sensor_msgs::PointCloud2 message = readCloudMessage(file);
    LabelledCloud cloud = pointsOf(message, file);
    cloud.lidar = file.parent_path().filename().string();
    const fs::path bag_file = bagIn(scene.folder);
    try {
      const auto bag = scene.kept->get<OpenBag>(bag_file);
      Pose X_GS = Pose::Identity();
      for (const geometry_msgs::TransformStamped& each : bag->transforms(message.header.stamp)) {
        if (each.child_frame_id != message.header.frame_id) continue;
        X_GS = poseOf(each.transform.translation, each.transform.rotation);
      }
      const std::string topic = bag->rootOf(scene.camera_index) + "/objects";
      addObjects(cloud,
                 bag->at<visualization_msgs::MarkerArray>(topic, message.header.stamp).markers,
                 X_GS);
    } catch (const rosbag::BagException& error) {
      throw Error("'" + bag_file.string() + "': " + error.what());
    }
    clouds.push_back(std::move(cloud));
  }
  return clouds;
}

}  // namespace

Format format() { return {"synthetic_dataset/RosBag", true, readScene, nullptr, cloudsOf}; }

}  // namespace synthetic_dataset::formats::ros_bag
