#pragma once

/// Where Gazebo puts pictures on its round shapes (gazebo/common/MeshManager.cc, CreateSphere and
/// CreateCylinder, which gz-sim has taken over).

#include <Eigen/Core>

#include "world/description.h"

namespace synthetic_dataset::world {

/// A point of a surface in its picture.
struct PicturePoint {
  enum class Column {
    kTurns,  ///< u counts turns; where it jumps by a whole one, the picture's edges meet
    kFixed,  ///< u, for whatever triangle
    kAny,    ///< of a pole, where all columns of the picture meet
  };

  float u;
  float v;
  Column column = Column::kTurns;
};

/// A sphere about the origin: the picture goes around the y axis, from z to x, its upper edge at
/// +y.
[[nodiscard]] PicturePoint aroundY(const Eigen::Vector3f& position, const Eigen::Vector3f& normal);

/// A cylinder about the z axis: the picture goes around it from y to x, its upper edge *below*.
/// On the upper cap it is drawn together to a fan whose middle is its first pixel; on the lower one
/// so is its first row.
[[nodiscard]] PicturePoint aroundCylinder(const Eigen::Vector3f& position,
                                          const Eigen::Vector3f& normal);

/// Gives a mesh the texture coordinates of `wrapping`. Triangles stay where they are; vertices at
/// which the picture's edges meet are doubled.
void wrapAsGazebo(Mesh& mesh, PicturePoint (*wrapping)(const Eigen::Vector3f& position,
                                                       const Eigen::Vector3f& normal));

}  // namespace synthetic_dataset::world
