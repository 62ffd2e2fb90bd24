#include <algorithm>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <pluginlib/class_list_macros.hpp>

#include "plugins/kitti/kitti_labels.h"
#include "plugins/shared/cloud_files.h"
#include "plugins/shared/pose_formats.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {
namespace {

/// The point that a pixel shows, in the optical frame [m]; nothing if there is none.
std::optional<Eigen::Vector3d> pointAt(const CameraModel& camera, int u, int v, double depth) {
  if (depth == 0.0) return std::nullopt;
  if (camera.isPinhole()) {
    const Intrinsics& k = camera.intrinsics();
    return depth * Eigen::Vector3d((u - k.cx) / k.fx, (v - k.cy) / k.fy, 1.0);
  }
  const auto ray = camera.ray({u, v});
  if (!ray || ray->z() * depth <= 0.0) return std::nullopt;
  return *ray * (depth / ray->z());
}

/// The points that a scanner in the camera's place would measure in the direction of each pixel: x
/// ahead, y left, z up [m] and a reflectance, which is unknown: 0. A point lies kScanDepth behind
/// the surface, seen from the scanner: otherwise rounding could put points on a box's faces outside
/// the box.
std::string scanOf(const Scene& scene) {
  constexpr std::size_t kBytesOfAPoint = 16;
  const cv::Mat depth = scene.depth();
  std::string bytes;
  bytes.reserve(kBytesOfAPoint * depth.total());
  for (int v = 0; v < depth.rows; ++v) {
    const auto* row = depth.ptr<float>(v);
    for (int u = 0; u < depth.cols; ++u) {
      const auto p_C = pointAt(scene.camera, u, v, row[u]);
      if (!p_C) continue;
      const Eigen::Vector3d p = *p_C * (1.0 + kitti::kScanDepth / p_C->norm());
      for (const double number : {p.z(), -p.x(), -p.y(), 0.0}) {
        appendFloat(bytes, static_cast<float>(number));
      }
    }
  }
  return bytes;
}

}  // namespace

/// KITTI's object benchmark: `training/{image_2,label_2,calib,velodyne}/NNNNNN.*`,
/// `ImageSets/*.txt`.
/// http://www.cvlibs.net/datasets/kitti/eval_object.php, readme.txt of its devkit_object
class KittiWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    options_ = readKittiOptions(parameters, dataset);
    for (std::size_t i = 0; i < dataset.cameras.size(); ++i) {
      folders_.push_back(dataset.cameraFolder(i));
    }
    // OpenPCDet and MMDetection3D open all of these, even if they are empty.
    splits_ = {"train", "val", kTest};
    for (const std::string& split : dataset.splitFolders()) {
      if (std::count(splits_.begin(), splits_.end(), split) == 0) splits_.push_back(split);
    }
  }

  [[nodiscard]] Requirements doRequirements() const override {
    return kitti::requirementsOf(options_);
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    warnOfDistortion(scene.camera, output);
    std::string labels = kitti::labels(scene, options_, kitti::Benchmark::kObjects, output);
    const std::string number = sixDigits(scene.instant);
    const std::string training = folders_[scene.camera_index] + "training/";
    output.addImage(training + "image_2/" + number + ".png", scene.image);
    if (options_.velodyne || options_.lidar) {
      output.addText(training + "velodyne/" + number + ".bin",
                     options_.lidar ? kitti::lidarPoints(scene, options_) : scanOf(scene));
    }
    if (labels.empty()) {
      // OpenPCDet cannot load an image without a label line (its object3d_kitti.py,
      // kitti_dataset.py).
      output.addWarning("an image without any label is left out of ImageSets");
    } else {
      listImage(scene, number, output);
    }
    output.addText(training + "label_2/" + number + ".txt", std::move(labels));
    output.addText(training + "calib/" + number + ".txt",
                   kitti::calibration(scene.camera.intrinsics(),
                                      options_.lidar ? kitti::lidarInCamera(scene, options_)
                                                     : kitti::scannerInCamera()));
  }

  static void listImage(const Scene& scene, const std::string& number, SceneOutput& output) {
    const std::string split = scene.splitFolder();
    output.addRecord(imageSet(scene.camera_index, split), number);
    if (split == "train" || split == "val") {
      output.addRecord(imageSet(scene.camera_index, kTrainVal), number);
    }
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    for (std::size_t camera = 0; camera < folders_.size(); ++camera) {
      for (const std::string& split : splits_) addImageSet(records, output, camera, split);
      addImageSet(records, output, camera, kTrainVal);
      addTesting(records, output, camera);
    }
  }

  /// OpenPCDet and MMDetection3D look for the images listed in `test` in the folder `testing`.
  void addTesting(const SceneRecords& records, DatasetOutput& output, std::size_t camera) const {
    records.forEach(imageSet(camera, kTest), [&](std::int64_t, const std::string& number) {
      std::vector<std::string> files = {"image_2/" + number + ".png", "calib/" + number + ".txt",
                                        "label_2/" + number + ".txt"};
      if (options_.velodyne || options_.lidar) files.push_back("velodyne/" + number + ".bin");
      for (const std::string& file : files) {
        output.addLink(folders_[camera] + "testing/" + file, folders_[camera] + "training/" + file);
      }
    });
  }

  /// The channel for the image numbers of a list.
  [[nodiscard]] static std::string imageSet(std::size_t camera, const std::string& name) {
    return std::to_string(camera) + " " + name;
  }

  void addImageSet(const SceneRecords& records, DatasetOutput& output, std::size_t camera,
                   const std::string& name) const {
    output.addFile(folders_[camera] + "ImageSets/" + name + ".txt", [&](std::ostream& list) {
      records.forEach(
          imageSet(camera, name),
          [&](std::int64_t /*scene*/, const std::string& number) { list << number << '\n'; });
    });
  }

  static constexpr const char* kTrainVal = "trainval";
  static constexpr const char* kTest = "test";

  KittiOptions options_;
  std::vector<std::string> folders_;  ///< of each camera
  std::vector<std::string> splits_;
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::KittiWriter, synthetic_dataset::LabelWriter)
