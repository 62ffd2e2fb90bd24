#include <cmath>

#include <opencv2/imgcodecs.hpp>

#include "plugins/kitti/kitti_options.h"
#include "plugins/readback/camera_drawing.h"
#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::kitti {
namespace {

namespace fs = std::filesystem;

/// The matrix P2, of the camera that made the images.
Intrinsics readCamera(const fs::path& file) {
  for (const std::string& line : readLines(file)) {
    const auto words = wordsOf(line);
    if (words.size() != 13 || words[0] != "P2:") continue;
    const auto number = [&](std::size_t i) { return numberOf(words[i + 1], file); };
    return {number(0), number(5), number(2), number(6)};
  }
  throw Error("'" + file.string() + "': found no line of 'P2:' and 12 numbers");
}

/// As the devkit's matlab/computeBox3D.m: the box stands on its location, turned about the camera's
/// y axis; its length lies along its x.
std::array<Eigen::Vector3d, 8> cornersOf(const std::vector<double>& n) {
  const Eigen::Vector3d size(n[9], n[8], n[7]);  // length, width, height
  const double c = std::cos(n[13]);
  const double s = std::sin(n[13]);
  std::array<Eigen::Vector3d, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    const double along = ((i & 4U) != 0 ? 0.5 : -0.5) * size.x();
    const double across = ((i & 2U) != 0 ? 0.5 : -0.5) * size.y();
    const double up = (i & 1U) != 0 ? size.z() : 0.0;
    corners[i] = {c * along + s * across + n[10], n[11] - up, c * across - s * along + n[12]};
  }
  return corners;
}

LabelledPicture readScene(const WrittenScene& scene) {
  const fs::path image = scene.file(".png");
  const fs::path training = image.parent_path().parent_path();
  const std::string name = image.stem().string() + ".txt";
  const fs::path file = training / "label_2" / name;
  const Intrinsics camera = readCamera(training / "calib" / name);
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
    if (words[0] != kDontCare) addCuboid(label, camera, cornersOf(numbers));
    picture.labels.push_back(std::move(label));
  }
  return picture;
}

Expectation expectation(Parameters& parameters, const std::vector<ClassInfo>& classes) {
  return [options = readKittiOptions(parameters, classes)](const MeasuredScene& scene) {
    ExpectedLabels expected;
    for (const MeasuredObject& object : scene.objects) {
      const auto type = options.types.find(object.class_name);
      ExpectedLabel label{object.name, type == options.types.end() ? "" : type->second};
      label.box_tolerance = std::pow(10.0, -kKittiDecimals);
      if (object.labelled()) {
        label.box = scene.box(object, options.box);
      } else if (options.dont_care && object.isSeen()) {
        label.class_name = kDontCare;
        label.box = object.visible_box;
      }
      if (label.box) expected.labels.push_back(std::move(label));
    }
    return expected;
  };
}

}  // namespace

Format format() { return {"synthetic_dataset/Kitti", false, readScene, expectation}; }

}  // namespace synthetic_dataset::formats::kitti
