#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <sensor_msgs/image_encodings.h>
#include <pluginlib/class_list_macros.hpp>

#include "base/ros_messages/scene_messages.h"
#include "plugins/ros_bag/bag_recording.h"
#include "plugins/ros_bag/bag_scene.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// A ROS bag of all scenes, to be played together with the recording from which they were made:
/// images, camera info, depth, instances, poses, boxes. The pictures from which it is made are
/// beside it.
class RosBagWriter : public LabelWriter {
 private:
  struct Camera {
    std::string topic;  ///< "/front"
    bool rectified = true;
    ros_messages::CameraFrame frame;
  };

  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    readFile(parameters);
    readCompression(parameters);
    compressed_ = parameters.optional("compressed", false);
    depth_ = parameters.optional("depth", true);
    frames_ = ros_messages::SceneFrames(
        dataset.global_frame, parameters.optional<std::string>("frame_prefix", "synthetic/"));
    const std::string root = readRoot(parameters);
    const std::vector<std::string> topics = topicsOf(dataset, root);
    addCameras(dataset.cameras, topics);
    addLidars(parameters, dataset, topics);
    if (dataset.motions.size() > 1) {
      throw Error("a bag has one time line, and each of the " +
                  std::to_string(dataset.motions.size()) +
                  " motions has its own; leave this format out, or make each motion a dataset");
    }
  }

  /// The topic prefixes of all cameras, followed by those of all lidars.
  static std::vector<std::string> topicsOf(const DatasetInfo& dataset, const std::string& root) {
    std::vector<std::string> names;
    for (const CameraDescription& camera : dataset.cameras) names.push_back(camera.name);
    for (const LidarDescription& lidar : dataset.lidars) names.push_back(lidar.name);
    std::vector<std::string> topics = ros_messages::topicNames(names);
    for (std::string& topic : topics) topic = root + "/" + topic;
    return topics;
  }

  void addLidars(Parameters& parameters, const DatasetInfo& dataset,
                 const std::vector<std::string>& topics) {
    if (dataset.lidars.empty() || !parameters.optional("clouds", true)) return;
    lidars_ = dataset.lidars;
    lidar_topics_.assign(topics.begin() + static_cast<std::ptrdiff_t>(dataset.cameras.size()),
                         topics.end());
    object_classes_ = dataset.classes.size();
  }

  /// Poses shared by several cameras are written with the first one.
  void addCameras(const std::vector<CameraDescription>& cameras,
                  const std::vector<std::string>& topics) {
    std::set<std::string> frames;
    for (const CameraDescription& camera : cameras) {
      const bool is_first = cameras_.empty();
      cameras_.push_back({topics[cameras_.size()],
                          camera.model.distortion().model == DistortionModel::kNone,
                          {camera.frame, frames.insert(camera.frame).second, is_first}});
    }
  }

  void readFile(WriterParameters& parameters) {
    file_ = parameters.optional<std::string>("file", "dataset.bag");
    constexpr std::size_t kLongest = 200;
    const bool is_bag = file_.size() > 4 && file_.compare(file_.size() - 4, 4, ".bag") == 0;
    const bool is_name = std::none_of(file_.begin(), file_.end(), [](char c) {
      return c == '/' || static_cast<unsigned char>(c) < 0x20U || c == 0x7F;
    });
    if (is_bag && is_name && file_.size() <= kLongest) return;
    parameters.addError("file", "found '" + file_ +
                                    "'; it should be the name of a file in the writer's folder, "
                                    "'dataset.bag' for instance");
  }

  void readCompression(WriterParameters& parameters) {
    const std::map<std::string, rosbag::CompressionType> types = {
        {"none", rosbag::compression::Uncompressed},
        {"lz4", rosbag::compression::LZ4},
        {"bz2", rosbag::compression::BZ2}};
    const std::string found = parameters.optional<std::string>("compression", "none");
    const auto type = types.find(found);
    if (type != types.end()) {
      compression_ = type->second;
    } else {
      parameters.addError("compression", "found '" + found + "'; it should be none, lz4 or bz2");
    }
  }

  /// The prefix of all topics: "" or "/a/b".
  static std::string readRoot(WriterParameters& parameters) {
    const std::string prefix = parameters.optional<std::string>("topic_prefix", "");
    if (!std::all_of(prefix.begin(), prefix.end(), ros_messages::isTopicLetter)) {
      parameters.addError("topic_prefix", "found '" + prefix +
                                              "'; names of topics have letters, digits, '_' and "
                                              "'/' only");
    }
    const std::size_t begin = prefix.find_first_not_of('/');
    if (begin == std::string::npos) return "";
    return "/" + prefix.substr(begin, prefix.find_last_not_of('/') - begin + 1);
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements;
    requirements.visible_masks = true;
    requirements.depth = depth_;
    requirements.clouds = !lidars_.empty();
    for (const LidarDescription& lidar : lidars_) requirements.frames.push_back(lidar.frame);
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    output.addImage(imageFile(scene.name), scene.image);
    output.addImage(instancesFile(scene.name), scene.instance_map());
    if (depth_) output.addImage(depthFile(scene.name), scene.depth());
    output.addRecord(kScenes,
                     recordOf(makeBagScene(scene, cameras_.at(scene.camera_index).frame, frames_)));
    if (scene.camera_index == 0) writeClouds(scene, output);  // shared by all cameras
  }

  void writeClouds(const Scene& scene, SceneOutput& output) const {
    for (std::size_t i = 0; i < lidars_.size(); ++i) {
      BagCloud cloud;
      cloud.lidar = static_cast<std::uint32_t>(i);
      cloud.file = "clouds/" + lidars_[i].name + "/" + sceneNumber(scene.instant) + ".msg";
      const std::string frame = frames_.of(lidars_[i].frame);
      cloud.transform =
          ros_messages::transform(ros_messages::headerOf(scene.stamp, frames_.globalFrame()), frame,
                                  scene.transform(frames_.globalFrame(), lidars_[i].frame));
      output.addText(cloud.file, bytesOf(cloudMessage(ros_messages::headerOf(scene.stamp, frame),
                                                      *scene.clouds().at(i), object_classes_)));
      output.addRecord(kClouds, recordOf(cloud));
    }
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    output.addFileByName(file_, [&](const std::string& file) {
      try {
        BagRecording bag(file, compression_);
        records.forEach(kScenes, [&](std::int64_t /*scene*/, const std::string& record) {
          play(bagSceneOf(record), output, bag);
        });
        records.forEach(kClouds, [&](std::int64_t /*scene*/, const std::string& record) {
          playCloud(bagCloudOf(record), output, bag);
        });
        bag.close();
      } catch (const rosbag::BagException& exception) {
        throw Error("the bag '" + file_ + "' cannot be written: " + exception.what());
      }
    });
  }

  /// Poses come first, so that subscribers can place what follows.
  void play(const BagScene& scene, const DatasetOutput& files, BagRecording& bag) const {
    const Camera& camera = cameras_.at(scene.camera_index);
    const std_msgs::Header& header = scene.camera_info.header;
    if (!scene.transforms.transforms.empty()) bag.write("/tf", scene.stamp, scene.transforms);
    bag.write(camera.topic + "/camera_info", scene.camera_info);

    const std::string image = files.readFile(imageFile(scene.name));
    if (compressed_) {
      bag.writeCompressed(camera.topic + "/image_raw/compressed", header, image);
    } else {
      bag.writeImage(camera.topic + "/image_raw", header, sensor_msgs::image_encodings::BGR8,
                     image);
    }
    bag.writeImage(camera.topic + "/instances", header, sensor_msgs::image_encodings::MONO16,
                   files.readFile(instancesFile(scene.name)));
    if (depth_) playDepth(scene, camera, files, bag);
    bag.write(camera.topic + "/objects", scene.stamp, scene.objects);
  }

  void playCloud(const BagCloud& cloud, const DatasetOutput& files, BagRecording& bag) const {
    tf2_msgs::TFMessage transforms;
    transforms.transforms.push_back(cloud.transform);
    bag.write("/tf", cloud.transform.header.stamp, transforms);
    bag.write(lidar_topics_.at(cloud.lidar) + "/points", cloudIn(files.readFile(cloud.file)));
  }

  /// Writes the depth, and camera info on the topic where RViz and depth_image_proc look for it.
  static void playDepth(const BagScene& scene, const Camera& camera, const DatasetOutput& files,
                        BagRecording& bag) {
    const std::string topic = camera.topic + "/depth";
    bag.write(topic + "/camera_info", scene.camera_info);
    bag.writeDepth(topic + (camera.rectified ? "/image_rect_raw" : "/image_raw"),
                   scene.camera_info.header, files.readFile(depthFile(scene.name)));
  }

  [[nodiscard]] static std::string imageFile(const std::string& scene) {
    return "images/" + scene + ".png";
  }
  [[nodiscard]] static std::string instancesFile(const std::string& scene) {
    return "instances/" + scene + ".png";
  }
  [[nodiscard]] static std::string depthFile(const std::string& scene) {
    return "depth/" + scene + ".tiff";
  }

  static constexpr const char* kScenes = "scenes";  // channel of records
  static constexpr const char* kClouds = "clouds";  // channel of records

  std::string file_;
  rosbag::CompressionType compression_ = rosbag::compression::Uncompressed;
  bool compressed_ = false;
  bool depth_ = true;
  ros_messages::SceneFrames frames_{"", ""};
  std::vector<Camera> cameras_;
  std::vector<LidarDescription> lidars_;  ///< whose clouds are in the bag
  std::vector<std::string> lidar_topics_;
  std::size_t object_classes_ = 0;
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::RosBagWriter, synthetic_dataset::LabelWriter)
