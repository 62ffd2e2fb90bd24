#pragma once

#include <map>
#include <vector>

#include <Eigen/Core>

#include "world/description.h"

namespace synthetic_dataset::world {

/// How a world is lit and painted for a while: what of its description may differ from scene to
/// scene while its things stay the same.
struct Look {
  explicit Look(const Description& description)
      : lights(description.lights),
        ambient(description.ambient),
        background(description.background) {}

  std::vector<Light> lights;   ///< as many as the description has, of the same types, in its order
  Eigen::Vector3f ambient;     ///< sRGB-encoded
  Eigen::Vector3f background;  ///< sRGB-encoded

  /// What surfaces wear instead of the materials that they were made with. Each is as transparent
  /// as what it replaces, double-sided and lit if that is, and has a normal or an emissive map only
  /// if that has one.
  std::map<const Material*, Material> materials;
};

}  // namespace synthetic_dataset::world
