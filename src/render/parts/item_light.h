#pragma once

#include <Eigen/Core>

#include "world/description.h"

namespace synthetic_dataset::render {

/// The members of ClassicLanes that are constant over a surface.
struct ClassicLight {
  Eigen::Vector3f ambient{0.0F, 0.0F, 0.0F};  ///< times the scene's
  Eigen::Vector3f emissive{0.0F, 0.0F, 0.0F};
  Eigen::Vector3f diffuse{0.0F, 0.0F, 0.0F};
  Eigen::Vector3f specular{0.0F, 0.0F, 0.0F};
  Eigen::Vector3f glow{0.0F, 0.0F, 0.0F};  ///< times its picture's colour
  float shininess = 0.0F;
};

[[nodiscard]] ClassicLight classicLight(const world::Material& material);

/// Lighting properties that are constant over an item.
struct ItemLight {
  Eigen::Vector3f emissive{0.0F, 0.0F, 0.0F};  ///< linear
  float reflectance = 0.0F;                    ///< below 0 where light leaves it as it is
  ClassicLight classic;                        ///< in the others' place in its worlds
};

/// Whether a material's emissive picture is another than its own, by which Gazebo Classic
/// multiplies all light but highlights.
[[nodiscard]] bool hasGlowOfItsOwn(const world::Material& material);

}  // namespace synthetic_dataset::render
