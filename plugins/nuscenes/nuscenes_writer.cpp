#include <algorithm>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <pluginlib/class_list_macros.hpp>

#include "plugins/nuscenes/nuscenes_categories.h"
#include "plugins/nuscenes/nuscenes_frames.h"
#include "plugins/nuscenes/nuscenes_options.h"
#include "plugins/nuscenes/nuscenes_scenes.h"
#include "plugins/nuscenes/nuscenes_tables.h"
#include "plugins/shared/cloud_files.h"
#include "plugins/shared/json.h"
#include "plugins/shared/pose_formats.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// nuScenes: `samples/CAM_*/` with images, `samples/LIDAR_TOP/` with a lidar's points, `lidarseg/`
/// with their categories, `sweeps/` with the same for the data between samples but without
/// categories, and JSON tables that refer to one another by tokens.
/// https://www.nuscenes.org/nuscenes#data-format, https://github.com/nutonomy/nuscenes-devkit
/// (docs/schema_nuscenes.md)
class NuScenesWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    dataset.refuseVaryingIntrinsics("calibrated_sensor.json");
    options_ = readNuScenesOptions(parameters, dataset);
    if (const auto problem = nuscenes::sceneNameProblem(dataset)) parameters.addError("", *problem);
    dataset_ = dataset;
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements = requirementsOf(options_.box);
    requirements.visibility = true;
    if (options_.lidar) {
      requirements.clouds = true;
      requirements.frames = {dataset_.lidars[*options_.lidar].frame};
    }
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    warnOfDistortion(scene.camera, output);
    nuscenes::Frame frame = frameOf(scene);
    frame.camera = static_cast<std::int64_t>(scene.camera_index);
    frame.file = folderOf(scene) + nuScenesChannel(dataset_.cameras, scene.camera_index) + "/" +
                 scene.flatName() + "." + options_.image_format;
    frame.X_GE = nuscenes::placementOf(scene.X_GC * bodyInCamera());
    if (isKeyframe(scene)) addSeen(scene, frame);
    output.addImage(frame.file, scene.image);
    output.addRecord(kFrames, nuscenes::recordOf(frame));
    // All cameras of an instant have the same clouds.
    if (options_.lidar && scene.camera_index == 0) writeCloud(scene, output);
  }

  /// Whether the scene is annotated, which also determines the folder of its files.
  [[nodiscard]] bool isKeyframe(const Scene& scene) const {
    return isNuScenesKeyframe(dataset_, options_, scene.instant);
  }
  [[nodiscard]] std::string folderOf(const Scene& scene) const {
    return isKeyframe(scene) ? "samples/" : "sweeps/";
  }

  void addSeen(const Scene& scene, nuscenes::Frame& frame) const {
    for (const SceneObject& object : scene.objects) {
      const auto box = boxOf(object, options_.box, scene.camera);
      if (object.labelled() && box) frame.objects.push_back(seenObject(object, *box));
    }
  }

  [[nodiscard]] nuscenes::Frame frameOf(const Scene& scene) const {
    nuscenes::Frame frame;
    frame.scene = scene.index;
    frame.instant = scene.instant;
    frame.microseconds = scene.stamp.count() / 1000;
    frame.sequence = static_cast<std::int64_t>(nuScenesSequence(dataset_, scene));
    return frame;
  }

  /// x to the right, y ahead, z up [m], the intensity, 0 .. 255, and the ring of each point, as
  /// read by LidarPointCloud.from_file of the devkit's utils/data_classes.py; and its category.
  void writeCloud(const Scene& scene, SceneOutput& output) const {
    const Cloud& cloud = *scene.clouds().at(*options_.lidar);
    nuscenes::Frame frame = frameOf(scene);
    frame.camera = static_cast<std::int64_t>(dataset_.cameras.size());
    frame.file = folderOf(scene) + kNuScenesLidar + "/" +
                 scene.name.substr(scene.name.rfind('/') + 1) + ".pcd.bin";
    frame.X_GE = nuscenes::placementOf(
        scene.transform(dataset_.global_frame, dataset_.lidars[*options_.lidar].frame));
    if (isKeyframe(scene)) addHitObjects(scene, cloud, frame);
    const nuscenes::PointCategories categories(dataset_);
    constexpr float kFullScale = 255.0F;
    std::string bytes;
    std::string of_points;
    for (const CloudPoint& point : cloud.points) {
      const Eigen::Vector3f& p_S = positionOf(point, options_.positions);
      const auto ring = static_cast<float>(point.ring);
      for (const float number : {-p_S.y(), p_S.x(), p_S.z(), kFullScale * point.intensity, ring}) {
        appendFloat(bytes, number);
      }
      of_points += static_cast<char>(categories.of(point));
    }
    output.addText(frame.file, std::move(bytes));
    if (options_.lidarseg && isKeyframe(scene)) {
      output.addText(nuscenes::lidarsegFile(options_.version, nuscenes::dataToken(dataset_, frame)),
                     std::move(of_points));
    }
    output.addRecord(kSweeps, nuscenes::recordOf(frame));
  }

  /// Adds the objects hit by the lidar.
  static void addHitObjects(const Scene& scene, const Cloud& cloud, nuscenes::Frame& frame) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      const std::int64_t points = cloud.points_of_objects.at(i);
      if (points == 0 || !scene.objects[i].X_GO) continue;
      frame.objects.push_back(hitObject(scene.objects[i], points));
    }
  }

  /// The pose in the optical frame of a frame with x ahead, y left and z up.
  [[nodiscard]] static Pose bodyInCamera() {
    Eigen::Matrix3d rotation;
    rotation << 0.0, -1.0, 0.0,  //
        0.0, 0.0, -1.0,          //
        1.0, 0.0, 0.0;
    return makePose(Eigen::Vector3d::Zero(), Eigen::Quaterniond(rotation));
  }

  [[nodiscard]] static nuscenes::SeenObject seenObject(const SceneObject& object, const Box& box) {
    nuscenes::SeenObject seen = placedObject(object);
    seen.visibility = object.visibility();
    seen.pixels = object.pixels.visible();
    seen.box = {box.left + 0.5, box.top + 0.5, box.right + 0.5, box.bottom + 0.5};
    return seen;
  }

  [[nodiscard]] static nuscenes::SeenObject hitObject(const SceneObject& object,
                                                      std::int64_t points) {
    nuscenes::SeenObject met = placedObject(object);
    met.points = points;
    return met;
  }

  [[nodiscard]] static nuscenes::SeenObject placedObject(const SceneObject& object) {
    const Eigen::Vector3d size = object.cuboid_O.size();
    Pose X_GB = *object.X_GO;
    X_GB.translation() = *object.X_GO * object.cuboid_O.centre();
    nuscenes::SeenObject placed;
    placed.object = object.instance - 1;
    placed.X_GB = nuscenes::placementOf(X_GB);
    placed.size = {size.y(), size.x(), size.z()};
    return placed;
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    std::vector<nuscenes::Frame> frames;
    for (const char* channel : {kFrames, kSweeps}) {
      records.forEach(channel, [&](std::int64_t scene, const std::string& record) {
        frames.push_back(nuscenes::frameOf(scene, record));
      });
    }
    // Cameras come before the lidar.
    std::stable_sort(frames.begin(), frames.end(),
                     [](const auto& a, const auto& b) { return a.instant < b.instant; });
    for (const nuscenes::Table& table : nuscenes::tablesOf(dataset_, frames, options_)) {
      output.addFile(options_.version + "/" + table.name + ".json", [&](std::ostream& file) {
        const char* separator = "\n";
        file << '[';
        table.make([&](const Json& record) {
          file << separator << jsonText(record);
          separator = ",\n";
        });
        file << "]\n";
      });
    }
    output.addFile(kNuScenesMap, [](std::ostream& file) {
      std::vector<uchar> bytes;
      cv::imencode(".png", cv::Mat(1, 1, CV_8UC1, cv::Scalar(0)), bytes);
      for (const uchar each : bytes) file.put(static_cast<char>(each));
    });
  }

  // Channels of records: of the cameras, and of the lidar.
  static constexpr const char* kFrames = "frames";
  static constexpr const char* kSweeps = "sweeps";

  NuScenesOptions options_;
  DatasetInfo dataset_;
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::NuScenesWriter, synthetic_dataset::LabelWriter)
