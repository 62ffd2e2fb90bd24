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
  /// @param skin  the scene with the skeleton
  /// @param animation  its animations move the nodes of the same names (the first one counts);
  ///     other nodes, or all without an animation, stay as modelled
  SkinPose(const aiScene& skin, const aiScene& animation);

  /// The transform that the bones of a mesh give each vertex, from the mesh's own frame to the
  /// scene's: the weighted mean of the bones' transforms (linear blend skinning, as in Gazebo).
  /// @return one per vertex; empty for a mesh without bones
  [[nodiscard]] std::vector<Eigen::Affine3d> displacements(const aiMesh& mesh) const;

 private:
  void place(const aiNode& node, const Eigen::Affine3d& parent);

  std::map<std::string, Eigen::Affine3d>
      keys_;  ///< of the nodes that the animation moves, relative to their parents
  std::map<std::string, Eigen::Affine3d> nodes_;  ///< of all nodes, in the scene's frame
};

}  // namespace synthetic_dataset::world
