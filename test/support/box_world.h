#pragma once

#include <memory>
#include <vector>

#include "world/world.h"

namespace synthetic_dataset::test {

/// A box's triangles, centred, each face with its own normal and with texture coordinates 0..1
/// (seen from outside: u to the right, v down, when the face's "up" is +z, or +y on top and
/// bottom).
[[nodiscard]] std::shared_ptr<const world::Mesh> boxMesh(const Eigen::Vector3d& size);

/// The eight corners of such a box.
[[nodiscard]] std::vector<Eigen::Vector3d> boxCorners(const Eigen::Vector3d& size);

/// Links to draw, their poses, and the objects that they belong to.
class Stage {
 public:
  /// Adds a box. @param object  index of the object that the box belongs to, -1 for the world
  void addBox(const Eigen::Vector3d& size, const Pose& X_WL, int object = -1,
              const world::Material& material = {});

  /// Adds a mesh in the link's own frame.
  void addMesh(const std::shared_ptr<const world::Mesh>& mesh, const Pose& X_WL, int object,
               const world::Material& material);

  [[nodiscard]] const std::vector<world::LinkInstance>& links() const { return instances_; }
  [[nodiscard]] const std::vector<Pose>& poses() const { return poses_; }
  [[nodiscard]] std::vector<Pose>& poses() { return poses_; }
  [[nodiscard]] std::vector<bool> all() const { return std::vector<bool>(poses_.size(), true); }

 private:
  std::vector<std::unique_ptr<world::Link>> links_;
  std::vector<world::LinkInstance> instances_;
  std::vector<Pose> poses_;
};

}  // namespace synthetic_dataset::test
