#include "output/verify/scene_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "base/image/image_encoder.h"
#include "output/files/digest.h"
#include "plugins/readback/files.h"

namespace synthetic_dataset::output {
namespace {

using formats::DepthNumbers;

constexpr const char* kUnknown = "the manifest does not say what is in it";

bool areSamePixels(const cv::Mat& one, const cv::Mat& other) {
  return one.data == other.data && one.size() == other.size() && one.type() == other.type();
}

/// Calls visit(square, cell) for each square for which the sum, least and greatest of the depths
/// are known.
template <class Visit>
void forEachCell(const cv::Size& size, const std::vector<float>& cells, const Visit& visit) {
  std::size_t at = 0;
  for (int top = 0; top < size.height; top += kDepthCell) {
    for (int left = 0; left < size.width && at + 3 <= cells.size(); left += kDepthCell, at += 3) {
      visit(cv::Rect(left, top, std::min(kDepthCell, size.width - left),
                     std::min(kDepthCell, size.height - top)),
            &cells[at]);
    }
  }
}

/// What is wrong with a depth image, given the sum of each square: finds any wrong depth that
/// changes the sum by more than rounding can.
/// @param depth  one channel; 0 for no depth
std::string depthProblem(const cv::Mat& depth, const DepthNumbers& numbers,
                         const std::vector<float>& cells) {
  constexpr double kSingle = 1e-6;  // rounding of single-precision sums
  std::string problem;
  forEachCell(depth.size(), cells, [&](const cv::Rect& square, const float* cell) {
    const double right = cell[0];
    // Points behind the camera or beyond the range of a pixel have no depth in the file.
    if (!problem.empty() || cell[1] < 0.0F || cell[2] > numbers.greatest) return;
    const double found = numbers.unit * cv::sum(depth(square))[0];
    const double rounding = numbers.rounding * cv::countNonZero(depth(square));
    if (std::abs(found - right) <= rounding + kSingle * (1.0 + right)) return;
    problem = "found depths that sum to " + std::to_string(found) + " m in the square at " +
              std::to_string(square.x) + ", " + std::to_string(square.y) + "; it should be " +
              std::to_string(right);
  });
  return problem;
}

/// Puts a depth beyond the range of the file's numbers where the file has none, so that a writer
/// sees that something is too far.
void addTooFar(cv::Mat& depth, const DepthNumbers& numbers, const std::vector<float>& cells) {
  forEachCell(depth.size(), cells, [&](const cv::Rect& square, const float* cell) {
    if (cell[2] <= numbers.greatest) return;
    cv::Mat_<float> part = depth(square);
    const auto nothing = std::find(part.begin(), part.end(), 0.0F);
    if (nothing != part.end()) *nothing = cell[2];
  });
}

}  // namespace

void ScenePictures::give(Scene& scene, Filling filling) const {
  const cv::Size size(scene.camera.width(), scene.camera.height());
  const auto picture = [&](const char* name, int type, const cv::Scalar& nothing,
                           const cv::Scalar& something) {
    const auto known = known_.find(name);
    if (known != known_.end()) return known->second;
    return cv::Mat(size, type, filling == Filling::kNothing ? nothing : something);
  };
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  scene.image = picture("image", CV_8UC3, cv::Scalar::all(0), cv::Scalar(30, 77, 140));
  scene.depth = picture("depth", CV_32FC1, cv::Scalar(0), cv::Scalar(1));
  scene.normals = picture("normals", CV_32FC3, cv::Scalar::all(0), cv::Scalar(0, 0, -1));
  scene.optical_flow =
      picture("optical_flow", CV_32FC2, cv::Scalar::all(kNone), cv::Scalar(1.5, -2.5));
}

void ScenePictures::giveClouds(Scene& scene, const DatasetInfo& dataset, Filling filling) const {
  // Every count differs between the two fillings.
  const std::size_t of_each = filling == Filling::kNothing ? 1 : 2;
  Cloud cloud;
  cloud.columns = static_cast<int>(
      of_each * (scene.objects.size() + dataset.world_classes.size() + std::size_t{1}));
  cloud.rings = 1;
  const auto add = [&](std::uint16_t instance, std::uint16_t class_number, std::uint16_t of_world) {
    for (std::size_t i = 0; i < of_each; ++i) {
      CloudPoint& point = cloud.points.emplace_back();
      point.position_S = point.position_at_stamp_S = {1.0F, 2.0F, 3.0F};
      point.column = static_cast<std::uint32_t>(cloud.points.size() - 1);
      point.instance = instance;
      point.class_number = class_number;
      point.world_class = of_world;
    }
  };
  add(0, 0, 0);
  for (const SceneObject& object : scene.objects) {
    add(static_cast<std::uint16_t>(object.instance),
        static_cast<std::uint16_t>(dataset.classIndex(object.class_id) + 1), 0);
  }
  for (std::size_t i = 1; i <= dataset.world_classes.size(); ++i) {
    add(0, 0, static_cast<std::uint16_t>(i));
  }
  Clouds clouds;
  for (cloud.lidar = 0; cloud.lidar < dataset.lidars.size(); ++cloud.lidar) {
    const PictureFacts* known = factsOf("cloud_" + std::to_string(cloud.lidar) + "_labels");
    cloud.points_of_objects.assign(scene.objects.size(), 0);
    for (std::size_t i = 0; known != nullptr && i < known->cells.size(); ++i) {
      cloud.points_of_objects.at(i) = static_cast<std::int64_t>(known->cells[i]);
    }
    clouds.push_back(std::make_shared<const Cloud>(cloud));
  }
  scene.clouds = std::move(clouds);
}

std::optional<std::string> ScenePictures::nameOf(const cv::Mat& pixels, const Scene& scene) {
  if (pixels.empty()) return std::nullopt;
  if (areSamePixels(pixels, scene.image)) return "image";
  if (areSamePixels(pixels, scene.depth())) return "depth";
  if (areSamePixels(pixels, scene.normals())) return "normals";
  if (areSamePixels(pixels, scene.optical_flow())) return "optical_flow";
  return std::nullopt;
}

std::string ScenePictures::take(const std::string& picture, const std::string& file) {
  if (base::imageFormat(file) == base::ImageFormat::kJpeg) {
    return problemOf(picture + ".jpg", digestOf(formats::readText(file)));
  }
  cv::Mat pixels = formats::readPicture(file, cv::IMREAD_UNCHANGED);
  std::string problem = problemOf(picture, digestOfPixels(pixels));
  if (problem.empty()) known_.emplace(picture, std::move(pixels));
  return problem;
}

std::string ScenePictures::take(const formats::DecodedPicture& picture) {
  if (picture.name.rfind("cloud_", 0) == 0) {
    return problemOf(picture.stored_as, digestOfPixels(picture.stored));
  }
  const PictureFacts* depth = factsOf("depth");
  const bool is_depth = picture.name == "depth";
  const cv::Size size(facts_.width, facts_.height);
  if (picture.stored.size() != size || (is_depth && depth == nullptr)) return kUnknown;
  std::string problem = picture.stored_as.empty()
                            ? depthProblem(picture.stored, picture.numbers, depth->cells)
                            : problemOf(picture.stored_as, digestOfPixels(picture.stored));
  if (!problem.empty() || isKnown(picture.name)) return problem;
  cv::Mat& pixels = known_[picture.name] = picture.pixels;
  if (is_depth) addTooFar(pixels, picture.numbers, depth->cells);
  return "";
}

const PictureFacts* ScenePictures::factsOf(const std::string& picture) const {
  for (const PictureFacts& each : facts_.known_pictures) {
    if (each.name == picture) return &each;
  }
  return nullptr;
}

std::string ScenePictures::problemOf(const std::string& picture, const std::string& digest) const {
  const PictureFacts* right = factsOf(picture);
  if (right == nullptr) return kUnknown;
  if (right->digest == digest) return "";
  return "its pixels are not those of the scene's " + picture;
}

}  // namespace synthetic_dataset::output
