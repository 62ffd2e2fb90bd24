#include "plugins/readback/kitti_files.h"

#include <array>
#include <cmath>
#include <map>

#include "plugins/kitti/kitti_options.h"
#include "plugins/readback/camera_drawing.h"
#include "plugins/readback/files.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats {
namespace {

/// The corners of a label's 3D box in the camera's frame [m], in the order of Cuboid::corners(). As
/// in the devkit's matlab/computeBox3D.m, the box stands on its location, rotated about the
/// camera's y axis; its length is along its x axis.
/// @param n  the seven columns from height on
std::array<Eigen::Vector3d, 8> kittiCorners(const std::vector<double>& n) {
  const Eigen::Vector3d size(n[2], n[1], n[0]);  // length, width, height
  const double c = std::cos(n[6]);
  const double s = std::sin(n[6]);
  std::array<Eigen::Vector3d, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    const double along = ((i & 4U) != 0 ? 0.5 : -0.5) * size.x();
    const double across = ((i & 2U) != 0 ? 0.5 : -0.5) * size.y();
    const double up = (i & 1U) != 0 ? size.z() : 0.0;
    corners[i] = {c * along + s * across + n[3], n[4] - up, c * across - s * along + n[5]};
  }
  return corners;
}

/// The 3 x 4 matrix of a calibration file, row by row.
/// @param name  the beginning of its line: "P2:"
std::vector<double> readMatrix(const std::filesystem::path& file, const std::string& name) {
  for (const std::string& line : readLines(file)) {
    const auto words = wordsOf(line);
    if (words.size() != 13 || words[0] != name) continue;
    std::vector<double> numbers;
    for (std::size_t i = 1; i < words.size(); ++i) numbers.push_back(numberOf(words[i], file));
    return numbers;
  }
  throw Error("'" + file.string() + "': found no line of '" + name + "' and 12 numbers");
}

}  // namespace

Intrinsics readKittiCamera(const std::filesystem::path& file) {
  const std::vector<double> k = readMatrix(file, "P2:");
  return {k[0], k[5], k[2], k[6]};
}

std::optional<std::string> kittiLidar(const WrittenScene& scene) {
  const auto velodyne = scene.settings.find("velodyne");
  if (velodyne == scene.settings.end()) return std::nullopt;
  std::string name = velodyne->second.text();
  if (name == "none" || name == "depth") return std::nullopt;
  return name;
}

LabelledCloud kittiCloud(const WrittenScene& scene,
                         const std::vector<std::vector<std::string>>& lines,
                         const std::filesystem::path& file,
                         const std::filesystem::path& calibration) {
  constexpr std::size_t kColumns = 15;
  LabelledCloud cloud;
  cloud.lidar = kittiLidar(scene).value_or("");
  addVelodynePoints(cloud, scene.file(".bin"));
  const std::vector<double> matrix = readMatrix(calibration, "Tr_velo_to_cam:");
  Pose X_CS = Pose::Identity();
  for (int i = 0; i < 12; ++i) X_CS(i / 4, i % 4) = matrix[static_cast<std::size_t>(i)];
  const Pose X_SC = X_CS.inverse();
  std::map<std::string, int> of_class;
  for (const std::vector<std::string>& words : lines) {
    if (words.size() != kColumns) {
      throw Error("'" + file.string() + "': found a label of " + std::to_string(words.size()) +
                  " columns");
    }
    if (words[0] == kDontCare) continue;
    std::vector<double> numbers;
    for (std::size_t i = 8; i < kColumns; ++i) numbers.push_back(numberOf(words[i], file));
    LabelledCloud::Object object;
    object.class_name = words[0];
    object.caption = words[0] + " " + std::to_string(++of_class[words[0]]);
    object.corners_S = kittiCorners(numbers);
    for (Eigen::Vector3d& corner : *object.corners_S) corner = X_SC * corner;
    cloud.objects[static_cast<std::uint16_t>(cloud.objects.size() + 1)] = object;
  }
  assignToBoxes(cloud);
  return cloud;
}

DrawnLabel kittiLabel(const std::vector<std::string>& words, const Intrinsics& camera,
                      const std::filesystem::path& file) {
  std::vector<double> numbers;
  for (std::size_t i = 1; i < words.size(); ++i) numbers.push_back(numberOf(words[i], file));
  DrawnLabel label;
  label.caption = words[0];
  label.class_names = {words[0]};
  label.box = Box{numbers[3] - 0.5, numbers[4] - 0.5, numbers[5] - 0.5, numbers[6] - 0.5};
  if (words[0] != kDontCare) {
    addCuboid(label, camera, kittiCorners({numbers.begin() + 7, numbers.end()}));
  }
  return label;
}

}  // namespace synthetic_dataset::formats
