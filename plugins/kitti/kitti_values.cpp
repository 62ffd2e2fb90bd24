#include "plugins/kitti/kitti_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "plugins/kitti/kitti_options.h"
#include "plugins/kitti/kitti_scan.h"
#include "plugins/readback/files.h"
#include "plugins/shared/kitti_columns.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::formats::kitti {
namespace {

std::string words(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += " " + fixed(number, kKittiDecimals);
  return text;
}

/// Edges as the format counts them: the image spans 0 to its width.
std::string edgesOf(const Box& box) {
  return words({box.left + 0.5, box.top + 0.5, box.right + 0.5, box.bottom + 0.5});
}

/// The devkit's readme: 0 fully visible, 1 partly, 2 largely occluded; by what is in the image.
int occlusionOf(const PixelCounts& pixels) {
  const auto in_image =
      static_cast<double>(std::max<std::int64_t>(1, pixels.silhouette_in_image()));
  const double seen = static_cast<double>(pixels.visible()) / in_image;
  return seen >= 0.9 ? 0 : seen >= 0.5 ? 1 : 2;
}

/// In -pi .. pi.
double turned(double angle) { return std::atan2(std::sin(angle), std::cos(angle)); }

class KittiValues : public ValueCheck {
 public:
  KittiValues(KittiOptions options, const DatasetInfo& dataset)
      : options_(std::move(options)), dataset_(dataset) {
    for (std::size_t camera = 0; camera < dataset_.cameras.size(); ++camera) {
      const std::string lists = dataset_.cameraFolder(camera) + "ImageSets/";
      for (const std::string& split : dataset_.splitFolders()) lists_[lists + split + ".txt"];
      lists_[lists + "trainval.txt"];
    }
  }

  void checkScene(const TrueScene& truth, FoundFiles& files) override {
    const Scene& scene = truth.scene;
    const std::string folder = dataset_.cameraFolder(scene.camera_index);
    std::string number = std::to_string(scene.instant);
    number.insert(0, number.size() < 6 ? 6 - number.size() : 0, '0');
    std::string lines;
    for (const SceneObject& object : scene.objects) lines += lineOf(object, scene.camera);
    files.compareWithScene(folder + "training/image_2/" + number + ".png", truth);
    compareLabels(folder + "training/label_2/" + number + ".txt", lines, files);
    files.compareText(folder + "training/calib/" + number + ".txt",
                      calibrationOf(scene.camera.intrinsics()));
    if (options_.velodyne) {
      compareScan(folder + "training/velodyne/" + number + ".bin", truth, files);
    }
    if (lines.empty()) return;  // OpenPCDet takes no image without a line
    const std::string split = scene.splitFolder();
    lists_[folder + "ImageSets/" + split + ".txt"] += number + "\n";
    if (split != "test") lists_[folder + "ImageSets/trainval.txt"] += number + "\n";
  }

  void checkDataset(FoundFiles& files) override {
    for (const auto& [name, lines] : lists_) files.compareText(name, lines);
  }

 private:
  static void compareLabels(const std::string& name, const std::string& lines, FoundFiles& files) {
    const auto file = files.take(name);
    if (!file) return;
    formats::compareText(withoutHalfTurns(readText(*file)), withoutHalfTurns(lines), name,
                         files.differences());
  }

  /// A half turn is written as pi or as -pi.
  static std::string withoutHalfTurns(std::string text) {
    const std::string minus_pi = " " + fixed(-M_PI, kKittiDecimals);
    for (std::size_t at = 0; (at = text.find(minus_pi, at)) != std::string::npos; ++at) {
      text.erase(at + 1, 1);
    }
    return text;
  }

  [[nodiscard]] std::string lineOf(const SceneObject& object, const CameraModel& camera) const {
    if (!object.labelled()) {
      const bool is_seen = options_.dont_care && object.pixels.visible() > 0;
      const auto box = is_seen ? boxOf(object, BoxChoice::kVisible, camera) : std::nullopt;
      if (!box) return "";
      return std::string(kDontCare) + " -1 -1 -10" + edgesOf(*box) +
             " -1 -1 -1 -1000 -1000 -1000 -10\n";
    }
    const auto box = boxOf(object, options_.box, camera);
    if (!box) return "";
    // The devkit's readme: height, width, length; the location is the middle of the lower face;
    // rotation_y turns about the camera's y axis, which looks down; alpha is that seen from here.
    const Cuboid& cuboid = object.cuboid_O;
    const Eigen::Vector3d size = cuboid.high - cuboid.low;
    const Eigen::Vector3d foot_O(0.5 * (cuboid.low.x() + cuboid.high.x()),
                                 0.5 * (cuboid.low.y() + cuboid.high.y()), cuboid.low.z());
    const Eigen::Vector3d foot_C = object.X_CO * foot_O;
    const Eigen::Vector3d ahead_C = object.X_CO.linear() * Eigen::Vector3d::UnitX();
    const double rotation = std::atan2(-ahead_C.z(), ahead_C.x());
    const double alpha = turned(rotation - std::atan2(foot_C.x(), foot_C.z()));
    return options_.types.at(object.class_name) + words({object.truncation()}) + " " +
           std::to_string(occlusionOf(object.pixels)) + words({alpha}) + edgesOf(*box) +
           words({size.z(), size.y(), size.x(), foot_C.x(), foot_C.y(), foot_C.z(), rotation}) +
           "\n";
  }

  static std::string calibrationOf(const Intrinsics& k) {
    std::string text;
    for (const char* camera : {"P0:", "P1:", "P2:", "P3:"}) {
      text += camera + words({k.fx, 0, k.cx, 0, 0, k.fy, k.cy, 0, 0, 0, 1, 0}) + "\n";
    }
    text += "R0_rect:" + words({1, 0, 0, 0, 1, 0, 0, 0, 1}) + "\n";
    // A scanner where the camera is, x ahead, y left, z up, and an IMU there too.
    text += "Tr_velo_to_cam:" + words({0, -1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0}) + "\n";
    text += "Tr_imu_to_velo:" + words({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}) + "\n";
    return text;
  }

  KittiOptions options_;
  DatasetInfo dataset_;
  std::map<std::string, std::string> lists_;  ///< of images, by file
};

}  // namespace

std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters, const DatasetInfo& dataset) {
  return std::make_unique<KittiValues>(readKittiOptions(parameters, dataset.classes), dataset);
}

}  // namespace synthetic_dataset::formats::kitti
