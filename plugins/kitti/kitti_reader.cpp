#include <opencv2/imgcodecs.hpp>

#include "plugins/kitti/kitti_expectation.h"
#include "plugins/kitti/kitti_values.h"
#include "plugins/readback/camera_drawing.h"
#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "plugins/readback/kitti_files.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::kitti {
namespace {

namespace fs = std::filesystem;

LabelledPicture readScene(const WrittenScene& scene) {
  const fs::path image = scene.file(".png");
  const fs::path training = image.parent_path().parent_path();
  const std::string name = image.stem().string() + ".txt";
  const fs::path file = training / "label_2" / name;
  const Intrinsics camera = readKittiCamera(training / "calib" / name);
  LabelledPicture picture{readPicture(image, cv::IMREAD_COLOR), {}};
  for (const std::string& line : readLines(file)) {
    const auto words = wordsOf(line);
    if (words.size() != 15) throw Error("'" + file.string() + "': found the line '" + line + "'");
    std::vector<double> numbers;
    for (std::size_t i = 1; i < words.size(); ++i) numbers.push_back(numberOf(words[i], file));
    DrawnLabel label;
    label.caption = words[0];
    label.class_names = {words[0]};
    label.box = Box{numbers[3] - 0.5, numbers[4] - 0.5, numbers[5] - 0.5, numbers[6] - 0.5};
    if (words[0] != kDontCare)
      addCuboid(label, camera, kittiCorners({numbers.begin() + 7, numbers.end()}));
    picture.labels.push_back(std::move(label));
  }
  return picture;
}

Expectation expectation(Parameters& parameters, const std::vector<ClassInfo>& classes) {
  return [options = readKittiOptions(parameters, classes)](const MeasuredScene& scene) {
    return expectedKittiLabels(options, scene);
  };
}

}  // namespace

Format format() { return {"synthetic_dataset/Kitti", false, readScene, expectation, valueCheck}; }

}  // namespace synthetic_dataset::formats::kitti
