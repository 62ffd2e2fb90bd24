#include <opencv2/imgcodecs.hpp>

#include "plugins/pvnet/pvnet_pose.h"
#include "plugins/readback/camera_drawing.h"
#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::formats::pvnet {
namespace {

namespace fs = std::filesystem;

Pose readPose(const fs::path& file) {
  try {
    return poseOfNumpy(readText(file));
  } catch (const Error& error) {
    throw Error("'" + file.string() + "': " + error.what());
  }
}

/// Lines of three numbers.
std::vector<Eigen::Vector3d> readPoints(const fs::path& file) {
  std::vector<Eigen::Vector3d> points;
  for (const std::string& line : readLines(file)) {
    const auto words = wordsOf(line);
    if (words.size() != 3) throw Error("'" + file.string() + "': found the line '" + line + "'");
    points.emplace_back(numberOf(words[0], file), numberOf(words[1], file),
                        numberOf(words[2], file));
  }
  return points;
}

/// @param writer_folder  contains a folder for each object
DrawnLabel readObject(const fs::path& image, const fs::path& writer_folder) {
  const fs::path scenes = image.parent_path().parent_path();
  const fs::path folder = scenes.parent_path();
  const std::string name = image.stem().string();
  const auto k = readPoints(folder / "camera.txt");
  const auto corners_O = readPoints(folder / "corners.txt");
  if (k.size() != 3 || corners_O.size() != 8) {
    throw Error("'" + folder.string() + "': camera.txt should have 3 lines, corners.txt 8");
  }
  const Intrinsics camera{k[0].x(), k[1].y(), k[0].z(), k[1].z()};
  const Pose X_CO = readPose(scenes / "pose" / (name + ".npy"));
  DrawnLabel label;
  label.caption = folder.lexically_relative(writer_folder).string();
  label.object_name = folder.lexically_relative(writer_folder).begin()->string();
  label.X_CO = X_CO;
  label.mask = readPicture(scenes / "mask" / (name + ".png"), cv::IMREAD_GRAYSCALE);
  std::array<Eigen::Vector3d, 8> corners_C;
  for (std::size_t i = 0; i < 8; ++i) corners_C[i] = X_CO * corners_O[i];
  addCuboid(label, camera, corners_C);
  addAxes(label, camera, X_CO, 0.5 * (corners_O[7] - corners_O[0]).norm());
  for (const Eigen::Vector3d& p_O : readPoints(folder / "fps.txt")) {
    const Eigen::Vector3d p_C = X_CO * p_O;
    label.keypoints.emplace_back(camera.fx * p_C.x() / p_C.z() + camera.cx,
                                 camera.fy * p_C.y() / p_C.z() + camera.cy);
  }
  return label;
}

LabelledPicture readScene(const WrittenScene& scene) {
  LabelledPicture picture;
  for (const fs::path& file : scene.files) {
    if (file.parent_path().filename() != "rgb") continue;
    if (picture.image.empty()) picture.image = readPicture(file, cv::IMREAD_COLOR);
    picture.labels.push_back(readObject(file, scene.folder));
  }
  return picture;
}

}  // namespace

Format format() { return {"synthetic_dataset/PvNet", true, readScene}; }

}  // namespace synthetic_dataset::formats::pvnet
