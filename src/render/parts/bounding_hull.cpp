#include "render/parts/bounding_hull.h"

#include <algorithm>
#include <array>
#include <limits>

#include <Eigen/LU>

#include "render/parts/bounds.h"

namespace synthetic_dataset::render {
namespace {

/// The points p with normal * p <= offset.
struct HalfSpace {
  Eigen::Vector3d normal;  ///< of unit length
  double offset;           ///< [m]
};

std::vector<Eigen::Vector3d> directions() {
  std::vector<Eigen::Vector3d> all;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const Eigen::Vector3d direction(x, y, z);
        if (!direction.isZero()) all.push_back(direction.normalized());
      }
    }
  }
  return all;
}

std::vector<HalfSpace> halfSpacesRound(const world::Mesh& mesh) {
  std::vector<HalfSpace> spaces;
  for (const Eigen::Vector3d& normal : directions()) {
    double most = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3f& position : mesh.positions) {
      most = std::max(most, normal.dot(position.cast<double>()));
    }
    spaces.push_back({normal, most});
  }
  return spaces;
}

/// The corners of the half-spaces' intersection: the points where three of the planes meet, inside
/// all the others.
/// @param tolerance  [m]
std::vector<Eigen::Vector3d> meetingPoints(const std::vector<HalfSpace>& spaces, double tolerance) {
  constexpr double kParallel = 1e-9;
  std::vector<Eigen::Vector3d> corners;
  const auto add = [&](const Eigen::Vector3d& corner) {
    const bool is_within = std::all_of(spaces.begin(), spaces.end(), [&](const HalfSpace& space) {
      return space.normal.dot(corner) <= space.offset + tolerance;
    });
    const bool is_new =
        std::none_of(corners.begin(), corners.end(), [&](const Eigen::Vector3d& other) {
          return (other - corner).cwiseAbs().maxCoeff() <= tolerance;
        });
    if (is_within && is_new) corners.push_back(corner);
  };
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        Eigen::Matrix3d normals;
        normals << spaces[i].normal.transpose(), spaces[j].normal.transpose(),
            spaces[k].normal.transpose();
        if (std::abs(normals.determinant()) < kParallel) continue;
        add(normals.inverse() *
            Eigen::Vector3d(spaces[i].offset, spaces[j].offset, spaces[k].offset));
      }
    }
  }
  return corners;
}

}  // namespace

std::vector<Eigen::Vector3d> BoundingHull::cornersWith(double margin) const {
  if (margin == 0.0 || corners.empty()) return corners;
  if (margin < radius) {
    // Scaled about its inner ball's centre, a convex body grows by at least the margin.
    std::vector<Eigen::Vector3d> grown;
    for (const Eigen::Vector3d& corner : corners) {
      grown.emplace_back(centre + (1.0 + margin / radius) * (corner - centre));
    }
    return grown;
  }
  Bounds box;
  for (const Eigen::Vector3d& corner : corners) box.extend(corner);
  const Eigen::Vector3d beside = Eigen::Vector3d::Constant(margin);
  return cornersOf(Bounds(box.min() - beside, box.max() + beside));
}

BoundingHull boundingHullOf(const world::Mesh& mesh) {
  if (mesh.positions.empty()) return {};
  constexpr double kRelativeTolerance = 1e-7;
  Bounds box;
  for (const Eigen::Vector3f& position : mesh.positions) box.extend(position.cast<double>());
  const double tolerance =
      kRelativeTolerance * (box.sizes().maxCoeff() + box.center().cwiseAbs().maxCoeff());
  const std::vector<HalfSpace> spaces = halfSpacesRound(mesh);
  BoundingHull hull;
  hull.corners = meetingPoints(spaces, tolerance);
  hull.centre = box.center();
  hull.radius = std::numeric_limits<double>::infinity();
  for (const HalfSpace& space : spaces) {
    hull.radius = std::min(hull.radius, space.offset - space.normal.dot(hull.centre));
  }
  hull.radius = std::max(hull.radius, 0.0);
  return hull;
}

}  // namespace synthetic_dataset::render
