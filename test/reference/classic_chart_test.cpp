/// Charts of materials, lights and shapes, against Gazebo Classic 11's pictures of them.

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "reference/reference_folder.h"
#include "render/renderer.h"
#include "world/camera_frames.h"
#include "world/files/gazebo_folders.h"
#include "world/world.h"
#include "world/world_loader.h"

namespace synthetic_dataset {
namespace classic_chart_test {

namespace fs = std::filesystem;

/// How far the mean colour of a face may be from Gazebo's, in each channel. Where Gazebo's own
/// media is not installed, a picture of our own stands in for "Gazebo/Wood", and is not compared.
constexpr double kAllowed = 10.0;  // grey levels
constexpr int kFewestPixels = 60;

fs::path chartFolder() { return test::referenceFolder() / "gazebo/chart"; }

/// A view like those of the reference's look.py.
render::View viewOf(const std::array<double, 6>& pose) {
  constexpr double kFieldOfView = 1.2;
  constexpr int kWidth = 640, kHeight = 480;
  const double focal = 0.5 * kWidth / std::tan(0.5 * kFieldOfView);
  const CameraModel camera(kWidth, kHeight, {focal, focal, 0.5 * (kWidth - 1), 0.5 * (kHeight - 1)},
                           0.05, 1000.0);
  const Eigen::Quaterniond turn = Eigen::AngleAxisd(pose[5], Eigen::Vector3d::UnitZ()) *
                                  Eigen::AngleAxisd(pose[4], Eigen::Vector3d::UnitY()) *
                                  Eigen::AngleAxisd(pose[3], Eigen::Vector3d::UnitX());
  return {camera, makePose({pose[0], pose[1], pose[2]}, turn) * world::opticalInBody()};
}

std::vector<std::array<double, 6>> viewsOf(const fs::path& file) {
  std::vector<std::array<double, 6>> views;
  std::ifstream stream(file);
  for (std::array<double, 6> v{}; stream >> v[0] >> v[1] >> v[2] >> v[3] >> v[4] >> v[5];) {
    views.push_back(v);
  }
  return views;
}

/// The world without shadows, as Gazebo's pictures have none.
world::Description shadowless(const fs::path& world) {
  const world::ResourceFinder finder({chartFolder().string()}, nullptr);
  world::Description description = world::loadWorld(world.string(), finder);
  for (world::Light& light : description.lights) light.casts_shadow = false;
  return description;
}

/// A link and, if it is flat, a normal in tenths.
using Face = std::tuple<int, int, int, int>;
using Faces = std::map<Face, std::vector<cv::Point>>;

/// The pixels of each face, without their rims.
Faces facesOf(const render::LabelImages& labels, const std::vector<bool>& is_round) {
  Faces faces;
  cv::Mat numbers(labels.links.size(), CV_32SC1, cv::Scalar(0));
  std::map<Face, int> known;
  std::vector<Face> keys{{}};
  for (int v = 0; v < numbers.rows; ++v) {
    for (int u = 0; u < numbers.cols; ++u) {
      const int link = labels.links.at<int>(v, u);
      const cv::Vec3f n = labels.normals.at<cv::Vec3f>(v, u);
      const bool round = link == 0 || is_round[static_cast<std::size_t>(link - 1)];
      const auto part = [&](int i) { return round ? 0 : cvRound(10.0F * n[i]); };
      const auto [entry, is_new] = known.try_emplace(
          std::make_tuple(link, part(0), part(1), part(2)), static_cast<int>(keys.size()));
      if (is_new) keys.push_back(entry->first);
      numbers.at<int>(v, u) = entry->second;
    }
  }
  cv::Mat as_float, low, high;
  numbers.convertTo(as_float, CV_32F);
  cv::erode(as_float, low, cv::Mat::ones(7, 7, CV_8U));
  cv::dilate(as_float, high, cv::Mat::ones(7, 7, CV_8U));
  for (int v = 0; v < numbers.rows; ++v) {
    for (int u = 0; u < numbers.cols; ++u) {
      if (low.at<float>(v, u) != high.at<float>(v, u)) continue;
      faces[keys[static_cast<std::size_t>(numbers.at<int>(v, u))]].emplace_back(u, v);
    }
  }
  return faces;
}

cv::Vec3d meanOf(const cv::Mat& picture, const std::vector<cv::Point>& pixels) {
  cv::Vec3d sum(0, 0, 0);
  for (const cv::Point& pixel : pixels) sum += cv::Vec3d(picture.at<cv::Vec3b>(pixel));
  return sum / static_cast<double>(pixels.size());
}

/// A world to be compared with Gazebo's pictures of it.
class Chart {
 public:
  explicit Chart(const std::string& name)
      : name_(name), world_(shadowless(chartFolder() / (name + ".world")), {}, {}) {
    world_.advanceTo(Stamp(0), [](int, Stamp) { return world::ObjectPose(Pose::Identity()); });
    for (const world::LinkInstance& link : world_.links()) {
      const auto ends = [&](const std::string& end) {
        return link.model.size() >= end.size() &&
               link.model.compare(link.model.size() - end.size(), end.size(), end) == 0;
      };
      is_round_.push_back(ends("_sphere") || ends("_cylinder"));
    }
  }

  /// Counts the faces that are compared, and lists those with more than the allowed difference.
  void compare(int& faces, std::vector<std::string>& beyond) {
    render::Renderer renderer(world_.description(), world_.links(), {});
    const std::vector<bool> all(world_.links().size(), true);
    const fs::path folder = test::referenceFolder() / "gazebo/reference/chart" / name_;
    int number = 0;
    for (const auto& pose : viewsOf(folder / "views.txt")) {
      const std::string view_name = "view" + std::to_string(number++);
      const cv::Mat theirs = cv::imread((folder / (view_name + ".jpg")).string());
      ASSERT_FALSE(theirs.empty());
      const render::View view = viewOf(pose);
      const cv::Mat ours = renderer.colour(view, world_.linkPoses(), {all, all});
      render::LabelPass pass;
      pass.drawn = all;
      pass.links = true;
      pass.normals = true;
      const render::LabelImages labels = renderer.labels(view, world_.linkPoses(), pass);
      for (const auto& [face, pixels] : facesOf(labels, is_round_)) {
        if (static_cast<int>(pixels.size()) < kFewestPixels) continue;
        ++faces;
        const cv::Vec3d difference = meanOf(ours, pixels) - meanOf(theirs, pixels);
        const double worst = cv::norm(difference, cv::NORM_INF);
        if (worst <= kAllowed) continue;
        const int link = std::get<0>(face);
        if (isStandIn(link)) continue;
        beyond.push_back(
            name_ + " " + view_name + " " +
            (link == 0 ? "nothing" : world_.links()[static_cast<std::size_t>(link - 1)].model) +
            ": " + std::to_string(worst));
      }
    }
  }

 private:
  [[nodiscard]] bool isStandIn(int link) const {
    if (link == 0 || !world::installedGazebos().empty()) return false;
    return world_.links()[static_cast<std::size_t>(link - 1)].model.rfind("wood", 0) == 0;
  }

  std::string name_;
  world::World world_;
  std::vector<bool> is_round_;
};

class ClassicChart : public testing::TestWithParam<const char*> {};

TEST_P(ClassicChart, HasTheColoursOfGazeboOnLitAndUnlitFaces) {
  Chart chart(GetParam());
  int faces = 0;
  std::vector<std::string> beyond;
  chart.compare(faces, beyond);
  EXPECT_GE(faces, 100);
  for (const std::string& each : beyond) ADD_FAILURE() << each << " grey levels";
}

INSTANTIATE_TEST_SUITE_P(OfEachLight, ClassicChart,
                         testing::Values("sun", "ambient_one", "point", "spot"),
                         [](const auto& chart) { return std::string(chart.param); });

}  // namespace classic_chart_test
}  // namespace synthetic_dataset
