#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "plugins/readback/cloud_pictures.h"
#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "plugins/readback/kitti_files.h"
#include "plugins/readback/sequence_files.h"

namespace synthetic_dataset::formats::kitti_tracking {
namespace {

namespace fs = std::filesystem;

/// Columns of a label line after the frame number: the track and the columns of KITTI's objects.
constexpr std::size_t kColumns = 16;

LabelledPicture readScene(const WrittenScene& scene) {
  const SequenceFrame frame = frameOf(scene, scene.file(".png"));
  const fs::path training = scene.folder / "training";
  const fs::path file = training / "label_02" / (frame.sequence + ".txt");
  const Intrinsics camera = readKittiCamera(training / "calib" / (frame.sequence + ".txt"));
  const fs::path image = training / "image_02" / frame.sequence / (frame.name + ".png");
  LabelledPicture picture{readPicture(image, cv::IMREAD_COLOR), {}};
  for (const auto& words : scene.kept->get<SequenceLabels>(file)->of(frame, kColumns)) {
    picture.labels.push_back(kittiLabel({words.begin() + 1, words.end()}, camera, file));
    picture.labels.back().caption += " " + words[0];
  }
  return picture;
}

std::vector<DecodedPicture> picturesOf(const WrittenScene& scene, const CameraModel& /*camera*/,
                                       const DatasetInfo& dataset) {
  const auto name = kittiLidar(scene);
  const auto lidar = name ? lidarNamed(*name, dataset) : std::nullopt;
  if (!lidar) return {};
  return {velodynePicture(scene.file(".bin"), *lidar, scene.settings)};
}

std::vector<LabelledCloud> cloudsOf(const WrittenScene& scene) {
  if (!kittiLidar(scene)) return {};
  const SequenceFrame frame = frameOf(scene, scene.file(".png"));
  const fs::path training = scene.folder / "training";
  const fs::path labels = training / "label_02" / (frame.sequence + ".txt");
  std::vector<std::vector<std::string>> lines;
  for (const auto& words : scene.kept->get<SequenceLabels>(labels)->of(frame, kColumns)) {
    lines.emplace_back(words.begin() + 1, words.end());  // without the track
  }
  return {kittiCloud(scene, lines, labels, training / "calib" / (frame.sequence + ".txt"))};
}

}  // namespace

Format format() {
  return {"synthetic_dataset/KittiTracking", true, readScene, picturesOf, cloudsOf};
}

}  // namespace synthetic_dataset::formats::kitti_tracking
