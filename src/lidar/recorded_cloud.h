#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "base/placement.h"
#include "lidar/lidar_options.h"
#include "lidar/met_surface.h"
#include "lidar/scanned_world.h"
#include "lidar/world_moments.h"
#include "motion/recorded/cloud_points.h"
#include "synthetic_dataset/cloud.h"

namespace synthetic_dataset::lidar {

/// Where a scanner is while it measures, looked up so often that it goes straight in between.
class ScannerPath {
 public:
  /// @param times  from the stamp; where the pose is asked for
  /// @param poseAt  X_GS at such a time
  ScannerPath(const motion::TimeRange& times,
              const std::function<base::Placement(Duration offset)>& poseAt);

  [[nodiscard]] base::Placement at(Duration offset) const;

 private:
  motion::TimeRange times_;
  std::vector<base::Placement> X_GS_;  ///< from the first time on, a step apart; then at the last
};

/// Where everything is while a cloud is recorded.
struct RecordedMotion {
  std::vector<WorldMoment> moments;  ///< ascending, at least one
  std::vector<bool> present;         ///< the links that are there
  ScannerPath path;
  Pose X_GS_at_stamp = Pose::Identity();
};

/// A recorded cloud with labels.
struct LabelledCloud {
  Cloud cloud;
  std::int64_t unknown = 0;     ///< points that lie on nothing that the world has
  std::int64_t too_bright = 0;  ///< points whose recorded intensity is more than the full one
};

/// Gives each point of a recorded cloud the labels of what it lies on: of the surfaces that the ray
/// to it meets, where everything is at the point's time, the one nearest to the range that was
/// measured, if it is within the tolerance. With all of the processor's cores.
/// @param measured  its times since the scene's stamp
/// @param labels  of the world's links
[[nodiscard]] LabelledCloud labelledCloud(const ScannedWorld& world,
                                          const motion::MeasuredCloud& measured,
                                          const RecordedSweepOptions& options,
                                          const RecordedMotion& motion,
                                          const std::vector<LinkLabel>& labels, const Paint& paint);

}  // namespace synthetic_dataset::lidar
