#include "motion/map_message.h"

#include "motion/frame_names.h"

namespace synthetic_dataset::motion {
namespace {

/// An orientation of zeros, which a sender has forgotten, is none, as RViz has it.
Pose poseOf(const geometry_msgs::Pose& origin) {
  const auto& p = origin.position;
  const auto& q = origin.orientation;
  return makePose({p.x, p.y, p.z}, Eigen::Quaterniond(q.w, q.x, q.y, q.z));
}

}  // namespace

RecordedMap mapOf(const nav_msgs::OccupancyGrid& grid) {
  RecordedMap map{grid.info.width,
                  grid.info.height,
                  grid.info.resolution,
                  poseOf(grid.info.origin),
                  withoutLeadingSlashes(grid.header.frame_id),
                  grid.data};
  checkMap(map);
  return map;
}

}  // namespace synthetic_dataset::motion
