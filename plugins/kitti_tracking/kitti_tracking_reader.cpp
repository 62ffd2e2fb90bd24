#include <algorithm>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "plugins/kitti/kitti_options.h"
#include "plugins/readback/camera_drawing.h"
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
  const SequenceFrame frame = frameOf(scene, scene.files.front());
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
    std::vector<double> numbers;
    for (std::size_t i = 2; i < words.size(); ++i) numbers.push_back(numberOf(words[i], file));
    DrawnLabel label;
    label.caption = words[1] + " " + words[0];
    label.class_names = {words[1]};
    label.box = Box{numbers[3] - 0.5, numbers[4] - 0.5, numbers[5] - 0.5, numbers[6] - 0.5};
    if (words[1] != kDontCare) {
      addCuboid(label, camera, kittiCorners({numbers.begin() + 7, numbers.end()}));
    }
    picture.labels.push_back(std::move(label));
  }
  return picture;
}

}  // namespace

Format format() {
  return {"synthetic_dataset/KittiTracking", true, readScene};
}

}  // namespace synthetic_dataset::formats::kitti_tracking
