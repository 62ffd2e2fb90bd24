#include <algorithm>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "plugins/readback/cloud_pictures.h"
#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "plugins/readback/kitti_files.h"
#include "plugins/readback/sequence_files.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::kitti_tracking {
namespace {

namespace fs = std::filesystem;

// A line of a sequence's labels: the frame, then the track and the columns of KITTI's objects.
LabelledPicture readScene(const WrittenScene& scene) {
  constexpr std::size_t kColumns = 16;  // behind the frame
  if (scene.files.empty()) throw Error("'" + scene.folder.string() + "': no image of the scene");
  const SequenceFrame frame = frameOf(scene, scene.file(".png"));
  const fs::path training = scene.folder / "training";
  const fs::path file = training / "label_02" / (frame.sequence + ".txt");
  const Intrinsics camera = readKittiCamera(training / "calib" / (frame.sequence + ".txt"));
  std::string digits = frame.frame;
  digits.insert(0, 6 - std::min<std::size_t>(digits.size(), 6), '0');
  LabelledPicture picture{
      readPicture(training / "image_02" / frame.sequence / (digits + ".png"), cv::IMREAD_COLOR),
      {}};
  for (const auto& words : scene.kept->get<SequenceLabels>(file)->of(frame.frame)) {
    if (words.size() != kColumns) {
      throw Error("'" + file.string() + "': found a line of " + std::to_string(words.size() + 1) +
                  " columns");
    }
    picture.labels.push_back(kittiLabel({words.begin() + 1, words.end()}, camera, file));
    picture.labels.back().caption += " " + words[0];
  }
  return picture;
}

std::vector<DecodedPicture> picturesOf(const WrittenScene& scene, const CameraModel& /*camera*/,
                                       const DatasetInfo& dataset) {
  const auto velodyne = scene.settings.find("velodyne");
  if (velodyne == scene.settings.end()) return {};
  const auto lidar = lidarNamed(velodyne->second.text(), dataset);
  if (!lidar) return {};
  return {velodynePicture(scene.file(".bin"), *lidar, scene.settings)};
}

std::vector<LabelledCloud> cloudsOf(const WrittenScene& scene) {
  const auto velodyne = scene.settings.find("velodyne");
  if (velodyne == scene.settings.end()) return {};
  LabelledCloud cloud;
  cloud.lidar = velodyne->second.text();
  addVelodynePoints(cloud, scene.file(".bin"));
  const SequenceFrame frame = frameOf(scene, scene.file(".png"));
  const fs::path training = scene.folder / "training";
  const fs::path labels = training / "label_02" / (frame.sequence + ".txt");
  std::vector<std::vector<std::string>> lines;
  for (const auto& words : scene.kept->get<SequenceLabels>(labels)->of(frame.frame)) {
    lines.emplace_back(words.begin() + (words.empty() ? 0 : 1), words.end());  // without the track
  }
  cloud.objects =
      kittiObjects(lines, readKittiScanner(training / "calib" / (frame.sequence + ".txt")), labels);
  assignToBoxes(cloud);
  return {cloud};
}

}  // namespace

Format format() {
  return {"synthetic_dataset/KittiTracking", true, readScene, picturesOf, cloudsOf};
}

}  // namespace synthetic_dataset::formats::kitti_tracking
