#include "world/physics/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <LinearMath/btConvexHullComputer.h>

#include "world/physics/bullet_conversions.h"

namespace synthetic_dataset::world {
namespace {

/// The largest inset, as a share of the distance between the hull's centre and its nearest face.
constexpr double kLargestInset = 0.25;

/// Directions spread evenly over the sphere (a Fibonacci lattice; Gonzalez 2010, "Measurement of
/// areas on a sphere using Fibonacci and latitude-longitude lattices").
std::vector<Eigen::Vector3d> evenDirections(int count) {
  const double golden_angle = M_PI * (3.0 - std::sqrt(5.0));
  std::vector<Eigen::Vector3d> directions;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double radius = std::sqrt(1.0 - z * z);
    directions.emplace_back(radius * std::cos(golden_angle * i),
                            radius * std::sin(golden_angle * i), z);
  }
  return directions;
}

/// Splits the hull's faces, which are planar polygons, into fans of triangles.
std::vector<std::array<int, 3>> fans(const btConvexHullComputer& computer) {
  std::vector<std::array<int, 3>> triangles;
  for (int face = 0; face < computer.faces.size(); ++face) {
    const btConvexHullComputer::Edge* first = &computer.edges[computer.faces[face]];
    const int apex = first->getSourceVertex();
    for (const auto* edge = first->getNextEdgeOfFace(); edge->getTargetVertex() != apex;
         edge = edge->getNextEdgeOfFace()) {
      triangles.push_back({apex, edge->getSourceVertex(), edge->getTargetVertex()});
    }
  }
  return triangles;
}

}  // namespace

ConvexHull convexHull(const std::vector<Eigen::Vector3d>& points, double inset) {
  ConvexHull hull;
  if (points.empty()) return hull;
  btConvexHullComputer computer;
  const btScalar moved = computer.compute(
      points.front().data(), static_cast<int>(sizeof(Eigen::Vector3d)),
      static_cast<int>(points.size()), static_cast<btScalar>(inset), btScalar(kLargestInset));
  hull.inset = std::max(0.0, static_cast<double>(moved));
  for (int i = 0; i < computer.vertices.size(); ++i) {
    hull.vertices.push_back(fromBullet(computer.vertices[i]));
  }
  hull.triangles = fans(computer);
  return hull;
}

std::vector<Eigen::Vector3d> supportPoints(const std::vector<Eigen::Vector3d>& points, int count) {
  if (points.size() <= static_cast<std::size_t>(count)) return points;
  std::set<std::size_t> chosen;
  for (const Eigen::Vector3d& direction : evenDirections(count)) {
    const auto farthest = std::max_element(points.begin(), points.end(),
                                           [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
                                             return a.dot(direction) < b.dot(direction);
                                           });
    chosen.insert(static_cast<std::size_t>(farthest - points.begin()));
  }
  std::vector<Eigen::Vector3d> support;
  for (const std::size_t index : chosen) support.push_back(points[index]);
  return support;
}

}  // namespace synthetic_dataset::world
