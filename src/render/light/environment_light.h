#pragma once

#include <memory>

#include <Eigen/Core>

#include "render/light/matte_light.h"
#include "render/light/panorama_light.h"
#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {

/// How bright the light of a panorama is, as factors.
struct EnvironmentLevels {
  Eigen::Vector3f above{1.0F, 1.0F, 1.0F};  ///< for light that matte surfaces receive from above
  Eigen::Vector3f below{1.0F, 1.0F, 1.0F};  ///< for light that they receive from below
  float mirrored = 1.0F;
};

/// The light of a panorama that surrounds the world.
class EnvironmentLight {
 public:
  /// @param yaw  by which the panorama is turned about z, from x to y [rad]
  EnvironmentLight(std::shared_ptr<const PanoramaLight> panorama, double yaw,
                   const EnvironmentLevels& levels);

  /// Like MatteLight::arriving() and PanoramaLight::mirrored().
  /// @param normals_G, directions_G  in the global frame
  [[nodiscard]] Lanes3 arriving(const Lanes3& normals_G) const;
  [[nodiscard]] Lanes3 mirrored(const Lanes3& directions_G, const Lanes& roughness) const;

 private:
  std::shared_ptr<const PanoramaLight> panorama_;
  Eigen::Matrix3f R_PG_;  ///< P is the panorama's frame
  MatteLight matte_;
  float brightness_;  ///< of reflections
};

}  // namespace synthetic_dataset::render
