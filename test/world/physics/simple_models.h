#pragma once

/// Models of one or a few simple shapes, each made in one line.

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "world/description.h"

namespace synthetic_dataset::world {

inline Pose at(double x, double y, double z) {
  return makePose({x, y, z}, Eigen::Quaterniond::Identity());
}

inline Pose turnedAt(const Eigen::Vector3d& position, double angle, const Eigen::Vector3d& axis) {
  return makePose(position, Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.normalized())));
}

inline Collision collisionOf(Shape shape, const Pose& X_LC = Pose::Identity()) {
  Collision collision;
  collision.name = "collision";
  collision.X_LC = X_LC;
  collision.shape = std::move(shape);
  return collision;
}

inline Link linkOf(std::vector<Collision> collisions, const Pose& X_ML = Pose::Identity()) {
  Link link;
  link.name = "link";
  link.X_ML = X_ML;
  link.collisions = std::move(collisions);
  return link;
}

/// A model of one link with one collision, both at the model's origin.
inline Model modelOf(const std::string& name, const Shape& shape,
                     const Pose& X_WM = Pose::Identity()) {
  Model model;
  model.name = name;
  model.X_WM = X_WM;
  model.links = {linkOf({collisionOf(shape)})};
  return model;
}

inline Model staticModelOf(const std::string& name, const Shape& shape,
                           const Pose& X_WM = Pose::Identity()) {
  Model model = modelOf(name, shape, X_WM);
  model.is_static = true;
  return model;
}

/// The plane z = 0, solid below.
inline Model ground() { return staticModelOf("ground", PlaneShape{{0, 0, 1}}); }

/// A box about the origin with eight corners shared by its sides, two triangles a side; no normals.
inline std::shared_ptr<const Mesh> weldedBoxMesh(const Eigen::Vector3d& size) {
  auto mesh = std::make_shared<Mesh>();
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d sign((corner & 1) ? 0.5 : -0.5, (corner & 2) ? 0.5 : -0.5,
                               (corner & 4) ? 0.5 : -0.5);
    mesh->positions.emplace_back(size.cwiseProduct(sign).cast<float>());
  }
  mesh->indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                   2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  return mesh;
}

/// A sphere about the origin as `rings` rings of twice as many triangles; no normals.
inline std::shared_ptr<const Mesh> sphereMesh(double radius, int rings) {
  auto mesh = std::make_shared<Mesh>();
  const int around = 2 * rings;
  for (int ring = 0; ring <= rings; ++ring) {
    for (int k = 0; k < around; ++k) {
      const double polar = M_PI * ring / rings;
      const double azimuth = 2.0 * M_PI * k / around;
      mesh->positions.emplace_back(
          (radius * Eigen::Vector3d(std::sin(polar) * std::cos(azimuth),
                                    std::sin(polar) * std::sin(azimuth), std::cos(polar)))
              .cast<float>());
    }
  }
  for (int ring = 0; ring < rings; ++ring) {
    for (int k = 0; k < around; ++k) {
      const auto a = static_cast<std::uint32_t>(ring * around + k);
      const auto b = static_cast<std::uint32_t>(ring * around + (k + 1) % around);
      const auto below = static_cast<std::uint32_t>(around);
      mesh->indices.insert(mesh->indices.end(), {a, a + below, b, b, a + below, b + below});
    }
  }
  return mesh;
}

inline Description descriptionOf(std::vector<Model> models) {
  Description description;
  description.models = std::move(models);
  return description;
}

}  // namespace synthetic_dataset::world
