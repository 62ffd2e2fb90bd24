#include "plugins/cityscapes/cityscapes_files.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/Geometry>

#include "plugins/shared/json.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
std::vector<std::string> cityNames(const std::vector<CameraDescription>& cameras) {
  std::vector<std::string> cities;
  std::set<std::string> taken;
  for (const CameraDescription& camera : cameras) {
    std::string city = safeFileName(camera.name);
    std::replace(city.begin(), city.end(), '_', '-');
    const std::string plain = city;
    for (int i = 2; !taken.insert(city).second; ++i) city = plain + "-" + std::to_string(i);
    cities.push_back(city);
  }
  return cities;
}

std::string polygonsJson(const CameraModel& camera,
                         const std::vector<CityscapesPolygon>& polygons) {
  Json objects = Json::array();
  for (const CityscapesPolygon& polygon : polygons) {
    Json points = Json::array();
    for (const cv::Point& point : polygon.points) points.push_back({point.x, point.y});
    objects.push_back({{"label", polygon.label}, {"polygon", std::move(points)}});
  }
  const Json annotation = {
      {"imgHeight", camera.height()}, {"imgWidth", camera.width()}, {"objects", objects}};
  return jsonText(annotation) + "\n";
}

std::string cameraJson(const Scene& scene) {
  // B: the camera's body, x ahead, y left, z up; C, its optical frame, has x right, y down, z
  // ahead.
  Eigen::Matrix3d R_CB;
  R_CB << 0.0, -1.0, 0.0, 0.0, 0.0, -1.0, 1.0, 0.0, 0.0;
  const Eigen::Matrix3d R_GB = scene.X_GC.linear() * R_CB;
  const Eigen::Vector3d p_G = scene.X_GC.translation();
  const Intrinsics& intrinsics = scene.camera.intrinsics();
  // Looking straight up or down, roll and yaw rotate about the same axis: all of it counts as yaw.
  constexpr double kUpright = 1e-9;
  const bool is_upright = std::hypot(R_GB(2, 1), R_GB(2, 2)) < kUpright;
  const Json extrinsic = {{"x", p_G.x()},
                          {"y", p_G.y()},
                          {"z", p_G.z()},
                          {"roll", is_upright ? 0.0 : std::atan2(R_GB(2, 1), R_GB(2, 2))},
                          {"pitch", -std::asin(std::clamp(R_GB(2, 0), -1.0, 1.0))},
                          {"yaw", is_upright ? std::atan2(-R_GB(0, 1), R_GB(1, 1))
                                             : std::atan2(R_GB(1, 0), R_GB(0, 0))}};
  const Json intrinsic = {
      {"fx", intrinsics.fx}, {"fy", intrinsics.fy}, {"u0", intrinsics.cx}, {"v0", intrinsics.cy}};
  return indentedJson({{"extrinsic", extrinsic}, {"intrinsic", intrinsic}});
}

}  // namespace synthetic_dataset
