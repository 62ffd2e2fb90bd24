#include "world/physics/mass_properties.h"

#include <algorithm>
#include <cmath>

#include "world/physics/convex_hull.h"

namespace synthetic_dataset::world {
namespace {

/// A mesh thinner than this counts as a plate of this thickness, so that it has a mass at all.
constexpr double kThinnest = 1e-3;  // [m]

MassProperties centred(double mass, const Eigen::Vector3d& moments) {
  return {mass, Eigen::Vector3d::Zero(), moments.asDiagonal()};
}

MassProperties solidOf(const BoxShape& box) {
  const Eigen::Vector3d squares = box.size.cwiseAbs2();
  const double mass = box.size.prod();
  return centred(mass, mass / 12.0 *
                           Eigen::Vector3d(squares.y() + squares.z(), squares.x() + squares.z(),
                                           squares.x() + squares.y()));
}

MassProperties solidOf(const SphereShape& sphere) {
  const double mass = 4.0 / 3.0 * M_PI * std::pow(sphere.radius, 3);
  return centred(mass, Eigen::Vector3d::Constant(0.4 * mass * sphere.radius * sphere.radius));
}

MassProperties solidOf(const CylinderShape& cylinder) {
  const double r2 = cylinder.radius * cylinder.radius;
  const double mass = M_PI * r2 * cylinder.length;
  const double across = mass * (3.0 * r2 + cylinder.length * cylinder.length) / 12.0;
  return centred(mass, {across, across, 0.5 * mass * r2});
}

MassProperties solidOf(const PlaneShape&) { return {}; }

/// The box around the points, at least kThinnest wide.
MassProperties boxAround(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d lowest = points.front();
  Eigen::Vector3d highest = points.front();
  for (const Eigen::Vector3d& point : points) {
    lowest = lowest.cwiseMin(point);
    highest = highest.cwiseMax(point);
  }
  MassProperties box = solidOf(BoxShape{(highest - lowest).cwiseMax(kThinnest)});
  box.centre_F = 0.5 * (lowest + highest);
  return box;
}

/// Sums tetrahedra between the triangles and a point of the solid; the covariance of a tetrahedron
/// with one corner at the origin is from Blow & Binstock 2004, "How to find the inertia tensor (or
/// other mass properties) of a 3D solid body represented by a triangle mesh".
MassProperties polyhedron(const ConvexHull& hull) {
  const Eigen::Vector3d origin = hull.vertices.front();
  double volume = 0.0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const auto& triangle : hull.triangles) {
    Eigen::Matrix3d corners;
    for (int i = 0; i < 3; ++i) {
      corners.col(i) =
          hull.vertices[static_cast<std::size_t>(triangle[static_cast<std::size_t>(i)])] - origin;
    }
    const double part = std::abs(corners.determinant()) / 6.0;
    const Eigen::Vector3d sum = corners.rowwise().sum();
    volume += part;
    first += part / 4.0 * sum;
    second += part / 20.0 * (corners * corners.transpose() + sum * sum.transpose());
  }
  const Eigen::Vector3d centre = volume > 0.0 ? Eigen::Vector3d(first / volume) : first;
  const Eigen::Matrix3d covariance = second - volume * centre * centre.transpose();
  return {volume, origin + centre, covariance.trace() * Eigen::Matrix3d::Identity() - covariance};
}

MassProperties solidOf(const MeshShape& shape) {
  if (shape.mesh == nullptr || shape.mesh->positions.empty()) return {};
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3f& position : shape.mesh->positions) {
    points.push_back(position.cast<double>());
  }
  const MassProperties box = boxAround(points);
  const MassProperties hull = polyhedron(convexHull(points));
  constexpr double kFlat = 1e-3;  // of the box's volume; a hull below it is a sheet, not a solid
  return hull.mass > kFlat * box.mass ? hull : box;
}

}  // namespace

MassProperties seenFrom(const Pose& X_AB, const MassProperties& body_B) {
  const Eigen::Matrix3d R_AB = X_AB.linear();
  return {body_B.mass, X_AB * body_B.centre_F, R_AB * body_B.moments_F * R_AB.transpose()};
}

MassProperties combined(const std::vector<MassProperties>& bodies_F) {
  MassProperties all;
  for (const MassProperties& body : bodies_F) {
    all.mass += body.mass;
    all.centre_F += body.mass * body.centre_F;
  }
  if (all.mass <= 0.0) return {};
  all.centre_F /= all.mass;
  for (const MassProperties& body : bodies_F) {
    const Eigen::Vector3d offset = body.centre_F - all.centre_F;
    all.moments_F +=
        body.moments_F + body.mass * (offset.squaredNorm() * Eigen::Matrix3d::Identity() -
                                      offset * offset.transpose());
  }
  return all;
}

MassProperties solid(const Shape& shape) {
  return std::visit([](const auto& each) { return solidOf(each); }, shape);
}

MassProperties massOf(const Link& link) {
  if (link.inertia) {
    return {link.inertia->mass, link.inertia->centre_of_mass_L, link.inertia->moments_L};
  }
  std::vector<MassProperties> solids;
  for (const Collision& collision : link.collisions) {
    solids.push_back(seenFrom(collision.X_LC, solid(collision.shape)));
  }
  MassProperties link_mass = combined(solids);
  if (link_mass.mass > 0.0) {
    link_mass.moments_F /= link_mass.mass;
    link_mass.mass = 1.0;
  }
  return link_mass;
}

MassProperties massOf(const Model& model) {
  std::vector<MassProperties> links;
  for (const Link& link : model.links) links.push_back(seenFrom(link.X_ML, massOf(link)));
  return combined(links);
}

}  // namespace synthetic_dataset::world
