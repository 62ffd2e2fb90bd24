#include "lidar/lidar_options.h"
#include "lidar/ray_bodies.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::lidar {

struct RayBodies::Impl {};

bool canCastRays() { return false; }

std::string howToCastRays() {
  return "this build is without Embree, which casts a lidar's rays; apt-get install "
         "libembree-dev, and build again";
}

std::string rayCasterVersion() { return ""; }

RayBodies::RayBodies() { throw Error(howToCastRays()); }
RayBodies::~RayBodies() = default;

// The implementation that casts rays needs them to be members.
// NOLINTBEGIN(readability-convert-member-functions-to-static, performance-unnecessary-value-param)
std::size_t RayBodies::add(std::vector<RaySurface> /*surfaces*/) { throw Error(howToCastRays()); }

const std::vector<RaySurface>& RayBodies::surfaces() const { throw Error(howToCastRays()); }

std::optional<RayHit> RayBodies::meet(std::size_t /*body*/, const Eigen::Vector3d& /*origin_B*/,
                                      const Eigen::Vector3d& /*direction_B*/, double /*near*/,
                                      double /*far*/, const Paint& /*paint*/) const {
  throw Error(howToCastRays());
}
// NOLINTEND(readability-convert-member-functions-to-static, performance-unnecessary-value-param)

}  // namespace synthetic_dataset::lidar
