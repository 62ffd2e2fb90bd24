#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <assimp/scene.h>

namespace synthetic_dataset::world {

/// The pose that a skeleton has at the beginning of an animation.
class SkinPose {
 public:
  /// @param skin  with the skeleton; the pose refers to it
  /// @param animation  whose first animation moves nodes of the same names; those that it does not
  ///     move, or all without an animation, stay as they were modelled
  SkinPose(const aiScene& skin, const aiScene& animation);

  /// Where the bones of a mesh take each vertex, from the mesh's own frame to the scene's: the mean
  /// of the bones' displacements by weight (linear blend skinning, as in Gazebo).
  /// @return one a vertex; empty for a mesh without bones
  [[nodiscard]] std::vector<Eigen::Affine3d> displacements(const aiMesh& mesh) const;

 private:
  void place(const aiNode& node, const Eigen::Affine3d& parent);

  std::map<std::string, Eigen::Affine3d>
      keys_;  ///< of nodes that the animation moves, in their parents
  std::map<std::string, Eigen::Affine3d> nodes_;  ///< of all nodes, in the scene
};

}  // namespace synthetic_dataset::world
