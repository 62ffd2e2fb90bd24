#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "render/light/environment_light.h"
#include "render/light/light_setup.h"
#include "render/shadows/shadow_lookup.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// What all surfaces of a picture have in common.
struct LightingContext {
  std::vector<LightInView> lights;
  std::vector<std::vector<CastShadow>> shadows;  ///< of each light: none, one, or those of a cube
  Eigen::Vector3f ambient;                       ///< linear; in Gazebo Classic's worlds encoded
  Eigen::Vector3f up_C;
  float exposure;
  std::optional<world::Fog> fog;
  world::Simulator simulator = world::Simulator::kGz;  ///< whose light it is

  /// In the place of the ambient light; null for none.
  std::shared_ptr<const EnvironmentLight> environment = nullptr;
  Eigen::Matrix3f R_GC = Eigen::Matrix3f::Identity();  ///< for it
};

}  // namespace synthetic_dataset::render
