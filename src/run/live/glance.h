#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include <opencv2/core/mat.hpp>

#include "run/motion_run.h"
#include "run/setup/run_setup.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::run {

/// Pictures of a run while one of its cameras is moved by hand: a quarter of the pixels, without
/// anti-aliasing and labels. They are fast because the renderer is kept from one to the next.
class Glance {
 public:
  /// @param run  must not have made a scene yet
  explicit Glance(RunSetup run);

  [[nodiscard]] const RunSetup& run() const { return run_; }

  /// Whether it can show any number of instants, in any order. If not, it can only show one.
  [[nodiscard]] bool canGoOn() const;

  /// @param camera  its index; X_GC is the pose at which it is shown
  /// @return CV_8UC3
  /// @throws Error if there is no such instant, or its picture is recorded rather than drawn
  [[nodiscard]] cv::Mat picture(std::int64_t instant, std::size_t camera, const Pose& X_GC);

 private:
  [[nodiscard]] MotionSetup& motionOf(std::int64_t instant);

  RunSetup run_;
  std::unique_ptr<MotionRun> drawing_;  ///< of the motion shown last
};

}  // namespace synthetic_dataset::run
