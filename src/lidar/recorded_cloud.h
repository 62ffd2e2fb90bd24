#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "base/placement.h"
#include "lidar/lidar_options.h"
#include "lidar/scanned_world.h"
#include "lidar/surface_hit.h"
#include "lidar/world_moments.h"
#include "motion/recorded/cloud_points.h"
#include "synthetic_dataset/cloud.h"

namespace synthetic_dataset::lidar {

/// The path of a scanner while it measures, sampled so densely that it is straight between samples.
class ScannerPath {
 public:
  /// @param times  relative to the stamp; the times for which poses are needed
  /// @param poseAt  returns X_GS at such a time
  ScannerPath(const motion::TimeRange& times,
              const std::function<base::Placement(Duration offset)>& poseAt);

  [[nodiscard]] base::Placement at(Duration offset) const;

 private:
  motion::TimeRange times_;
  std::vector<base::Placement> X_GS_;  ///< a step apart from the first time on, and at the last
};

/// Where everything is while a cloud is recorded.
struct RecordedMotion {
  std::vector<WorldMoment> moments;  ///< ascending, at least one
  std::vector<bool> present;         ///< by link
  ScannerPath path;
  Pose X_GS_at_stamp = Pose::Identity();
};

/// A recorded cloud with labels.
struct LabelledCloud {
  Cloud cloud;
  std::int64_t unknown = 0;     ///< points that lie on no surface of the world
  std::int64_t too_bright = 0;  ///< points whose recorded intensity exceeds the full one
};

/// Gives each point of a recorded cloud the labels of the surface it lies on: of the surfaces that
/// the ray to it hits, with everything at its pose at the point's time, the one nearest to the
/// measured range, if it is within the tolerance. Uses all of the processor's cores.
/// @param measured  with times relative to the scene's stamp
/// @param labels  of the world's links
[[nodiscard]] LabelledCloud labelledCloud(const ScannedWorld& world,
                                          const motion::MeasuredCloud& measured,
                                          const RecordedSweepOptions& options,
                                          const RecordedMotion& motion,
                                          const std::vector<LinkLabel>& labels, const Paint& paint);

}  // namespace synthetic_dataset::lidar
