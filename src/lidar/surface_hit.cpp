#include "lidar/surface_hit.h"

#include "lidar/surface_look.h"

namespace synthetic_dataset::lidar {

Eigen::Vector3d normalOf(const SurfaceHit& met, const RaySurface& surface,
                         const Eigen::Vector3d& direction_W) {
  const SurfacePlace place{met.hit.triangle, met.hit.b1, met.hit.b2};
  const Eigen::Matrix3d R_WV = met.R_WB * surface.X_BV.linear();
  return R_WV * normalAt(*surface.mesh, place, R_WV.transpose() * direction_W);
}

void setLabel(const LinkLabel& label, CloudPoint& point) {
  point.instance = label.instance;
  point.class_number = label.class_number;
  point.world_class = label.world_class;
  point.part = label.part;
}

}  // namespace synthetic_dataset::lidar
