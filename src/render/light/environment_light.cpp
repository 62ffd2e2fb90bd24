#include "render/light/environment_light.h"

#include <utility>

#include <Eigen/Geometry>

namespace synthetic_dataset::render {

EnvironmentLight::EnvironmentLight(std::shared_ptr<const PanoramaLight> panorama, double yaw,
                                   const EnvironmentLevels& levels)
    : panorama_(std::move(panorama)),
      R_PG_(Eigen::AngleAxisd(-yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix().cast<float>()),
      matte_(MatteLight::sum(panorama_->above(), levels.above, panorama_->below(), levels.below)),
      brightness_(levels.mirrored) {}

Lanes3 EnvironmentLight::arriving(const Lanes3& normals_G) const {
  return matte_.arriving(rotated(R_PG_, normals_G));
}

Lanes3 EnvironmentLight::mirrored(const Lanes3& directions_G, const Lanes& roughness) const {
  return panorama_->mirrored(rotated(R_PG_, directions_G), roughness) * lanes(brightness_);
}

}  // namespace synthetic_dataset::render
