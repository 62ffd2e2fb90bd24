#include "world/mesh/model_geometry.h"

#include <algorithm>
#include <array>
#include <tuple>

#include <Eigen/Geometry>

#include "world/physics/convex_hull.h"

namespace synthetic_dataset::world {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// The corners of all triangles, without duplicates.
Points cornersOf(const Link& link) {
  Points points;
  for (const Visual& visual : link.visuals) {
    for (const Surface& surface : visual.surfaces) {
      for (const std::uint32_t index : surface.mesh->indices) {
        points.push_back(visual.X_LV * surface.mesh->positions[index].cast<double>());
      }
    }
  }
  const auto key = [](const Eigen::Vector3d& p) { return std::tuple(p.x(), p.y(), p.z()); };
  std::sort(points.begin(), points.end(),
            [&](const auto& a, const auto& b) { return key(a) < key(b); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// A half space; the inside of the hull is where the distance is negative.
struct HalfSpace {
  Eigen::Vector3d normal;
  double offset;
};

std::vector<HalfSpace> sidesOf(const ConvexHull& hull) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& vertex : hull.vertices) centre += vertex;
  if (!hull.vertices.empty()) centre /= static_cast<double>(hull.vertices.size());
  std::vector<HalfSpace> sides;
  for (const std::array<int, 3>& triangle : hull.triangles) {
    const auto corner = [&](std::size_t i) -> const Eigen::Vector3d& {
      return hull.vertices[static_cast<std::size_t>(triangle[i])];
    };
    Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    if (normal.norm() == 0.0) continue;
    normal.normalize();
    if (normal.dot(centre - corner(0)) > 0.0) normal = -normal;
    sides.push_back({normal, normal.dot(corner(0))});
  }
  return sides;
}

/// Leaves out points that lie inside a hull of a few of the others: they are never outermost.
Points outermost(Points points) {
  constexpr int kFew = 128;
  if (points.size() <= kFew) return points;
  const std::vector<HalfSpace> sides = sidesOf(convexHull(supportPoints(points, kFew)));
  Eigen::AlignedBox3d bounds;
  for (const Eigen::Vector3d& point : points) bounds.extend(point);
  // Bullet computes hulls on a grid of about 1/10000 of the extent.
  const double tolerance = 1e-3 * bounds.sizes().maxCoeff();
  const auto inside = [&](const Eigen::Vector3d& point) {
    return !sides.empty() && std::all_of(sides.begin(), sides.end(), [&](const HalfSpace& side) {
      return side.normal.dot(point) < side.offset - tolerance;
    });
  };
  points.erase(std::remove_if(points.begin(), points.end(), inside), points.end());
  return points;
}

}  // namespace

ModelGeometry::ModelGeometry(const std::vector<const Link*>& links) {
  for (const Link* link : links) points_L_.push_back(outermost(cornersOf(*link)));
}

bool ModelGeometry::isEmpty() const {
  return std::all_of(points_L_.begin(), points_L_.end(),
                     [](const Points& points) { return points.empty(); });
}

std::vector<Eigen::Vector3d> ModelGeometry::box(const std::vector<Pose>& X_OL) const {
  Eigen::AlignedBox3d bounds;
  for (std::size_t i = 0; i < points_L_.size(); ++i) {
    for (const Eigen::Vector3d& p_L : points_L_[i]) {
      bounds.extend(Eigen::Vector3d(X_OL[i] * p_L));
    }
  }
  Points corners;
  for (const double x : {bounds.min().x(), bounds.max().x()}) {
    for (const double y : {bounds.min().y(), bounds.max().y()}) {
      for (const double z : {bounds.min().z(), bounds.max().z()}) corners.emplace_back(x, y, z);
    }
  }
  return corners;
}

}  // namespace synthetic_dataset::world
