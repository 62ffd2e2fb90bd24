#pragma once

/// Visible, colliding boxes, and quantities that follow from their sizes alone.

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "synthetic_dataset/cuboid.h"
#include "world/physics/simple_models.h"
#include "world/world.h"

namespace synthetic_dataset::test {

/// A box about its model's origin.
struct SolidBox {
  std::string name;
  Eigen::Vector3d size{1, 1, 1};  ///< [m]
  Pose X_GB = Pose::Identity();

  [[nodiscard]] world::Model model() const {
    world::Model model = world::modelOf(name, world::BoxShape{size}, X_GB);
    world::Visual visual;
    visual.surfaces.push_back({world::weldedBoxMesh(size), {}});
    model.links[0].visuals.push_back(visual);
    return model;
  }

  [[nodiscard]] world::Model staticModel() const {
    world::Model standing = model();
    standing.is_static = true;
    return standing;
  }

  [[nodiscard]] Cuboid cuboid() const { return {-0.5 * size, 0.5 * size}; }

  /// How far a point is from the box [m]; inside, minus its depth.
  [[nodiscard]] double distanceTo(const Eigen::Vector3d& p_G) const {
    const Eigen::Vector3d beyond = Eigen::Vector3d(X_GB.inverse() * p_G).cwiseAbs() - 0.5 * size;
    const double deepest = beyond.maxCoeff();
    return deepest < 0.0 ? deepest : beyond.cwiseMax(0.0).norm();
  }

  /// Whether the straight line between two points hits the box (Kay and Kajiya's slabs).
  [[nodiscard]] bool isBetween(const Eigen::Vector3d& a_G, const Eigen::Vector3d& b_G) const {
    const Eigen::Vector3d a = X_GB.inverse() * a_G;
    const Eigen::Vector3d way = X_GB.inverse() * b_G - a;
    double enter = 0.0;
    double leave = 1.0;
    for (int i = 0; i < 3; ++i) {
      const double one = (-0.5 * size[i] - a[i]) / way[i];
      const double other = (0.5 * size[i] - a[i]) / way[i];
      enter = std::max(enter, std::min(one, other));
      leave = std::min(leave, std::max(one, other));
    }
    return enter < leave;
  }
};

/// How deep one box is inside the other [m], by points all over the first; negative if apart.
[[nodiscard]] inline double depthOf(const SolidBox& one, const SolidBox& other) {
  constexpr int kSteps = 12;
  double depth = -1e9;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      for (int k = 0; k <= kSteps; ++k) {
        const Eigen::Vector3d share(double(i) / kSteps, double(j) / kSteps, double(k) / kSteps);
        const Eigen::Vector3d p_B = (share.array() - 0.5).matrix().cwiseProduct(one.size);
        depth = std::max(depth, -other.distanceTo(one.X_GB * p_B));
      }
    }
  }
  return depth;
}

/// A floor of 40 m x 40 m whose top is at z = 0.
[[nodiscard]] inline SolidBox floorBox() { return {"floor", {40, 40, 1}, world::at(0, 0, -0.5)}; }

/// A world of static boxes and of objects that are to be placed.
[[nodiscard]] inline std::unique_ptr<world::World> worldOf(
    const std::vector<SolidBox>& standing, const std::vector<SolidBox>& objects,
    const std::vector<world::Model>& props = {}, bool drops_objects = false,
    const std::vector<SolidBox>& distractors = {}) {
  std::vector<world::Model> models = props;
  for (const SolidBox& box : standing) models.push_back(box.staticModel());
  std::vector<world::MovingObject> moving;
  for (const SolidBox& box : objects) moving.emplace_back(box.model());
  world::PhysicsOptions options;
  options.drops_objects = drops_objects;
  options.drops_distractors = !distractors.empty();
  std::vector<world::Model> others;
  for (const SolidBox& box : distractors) others.push_back(box.model());
  return std::make_unique<world::World>(world::descriptionOf(std::move(models)), std::move(moving),
                                        options, std::move(others));
}

/// How far counts are from being equal: for k counts, about k - 1, give or take a few times
/// sqrt(2 (k - 1)).
[[nodiscard]] inline double chiSquared(const std::vector<int>& counts) {
  double sum = 0.0;
  for (const int count : counts) sum += count;
  const double expected = sum / static_cast<double>(counts.size());
  double squares = 0.0;
  for (const int count : counts) squares += (count - expected) * (count - expected) / expected;
  return squares;
}

}  // namespace synthetic_dataset::test
