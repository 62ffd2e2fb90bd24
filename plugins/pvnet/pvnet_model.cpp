#include "plugins/pvnet/pvnet_model.h"

#include <algorithm>
#include <limits>

#include "plugins/shared/pose_formats.h"

namespace synthetic_dataset {
namespace {

constexpr std::size_t kFarthestPoints = 8;

Json listOf(const std::vector<Eigen::Vector3d>& points) {
  Json list = Json::array();
  for (const Eigen::Vector3d& point : points) list.push_back(numbersOf(point));
  return list;
}

/// Updates each point's smallest squared distance with that to one more chosen point.
void approach(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& chosen,
              std::vector<float>& distances) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f d = points[i] - chosen;
    distances[i] = std::min(distances[i], d.x() * d.x() + d.y() * d.y() + d.z() * d.z());
  }
}

}  // namespace

std::optional<PvNetModel> PvNetModel::of(const ObjectModel& model) {
  if (model.vertices.empty()) return std::nullopt;
  const Cuboid bounds = boundsOf(model);
  const auto corners = bounds.corners();
  return PvNetModel{model.diameter,
                    {corners.begin(), corners.end()},
                    bounds.centre(),
                    farthestPoints(model, kFarthestPoints)};
}

bool PvNetModel::projectsOntoImagePlane(const CameraModel& camera, const Pose& X_CO) const {
  const auto hasPlace = [&](const Eigen::Vector3d& p_O) {
    return camera.project(X_CO * p_O).has_value();
  };
  return hasPlace(centre) && std::all_of(corners.begin(), corners.end(), hasPlace) &&
         std::all_of(farthest_points.begin(), farthest_points.end(), hasPlace);
}

Json PvNetModel::annotation(const CameraModel& camera, const Pose& X_CO) const {
  const auto placeOf = [&](const Eigen::Vector3d& p_O) {
    const Eigen::Vector2d pixel = camera.project(X_CO * p_O).value();
    return Json::array({pixel.x(), pixel.y()});
  };
  const auto placesOf = [&](const std::vector<Eigen::Vector3d>& points_O) {
    Json list = Json::array();
    for (const Eigen::Vector3d& p_O : points_O) list.push_back(placeOf(p_O));
    return list;
  };
  return {{"corner_3d", listOf(corners)},      {"corner_2d", placesOf(corners)},
          {"center_3d", numbersOf(centre)},    {"center_2d", placeOf(centre)},
          {"fps_3d", listOf(farthest_points)}, {"fps_2d", placesOf(farthest_points)}};
}

std::vector<Eigen::Vector3d> farthestPoints(const ObjectModel& model, std::size_t count) {
  std::vector<Eigen::Vector3f> points;
  for (const ObjectModel::Vertex& vertex : model.vertices) {
    points.push_back(vertex.position.cast<float>());
  }
  Eigen::Vector3f low = points.front();
  Eigen::Vector3f high = points.front();
  for (const Eigen::Vector3f& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  // Squared distance to the nearest of the centre and all chosen points; 0 for a chosen point.
  std::vector<float> distances(points.size(), std::numeric_limits<float>::max());
  approach(points, (high + low) / 2.0F, distances);
  std::vector<Eigen::Vector3d> chosen;
  while (chosen.size() < count) {
    const auto farthest = std::max_element(distances.begin(), distances.end());
    const auto index = static_cast<std::size_t>(farthest - distances.begin());
    chosen.push_back(model.vertices[index].position);
    approach(points, points[index], distances);
  }
  return chosen;
}

}  // namespace synthetic_dataset
