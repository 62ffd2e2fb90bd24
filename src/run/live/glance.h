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
/// smooth edges and labels. What draws them is kept from one to the next, which is what makes them
/// quick.
class Glance {
 public:
  /// @param run  that has made no scene yet
  explicit Glance(RunSetup run);

  [[nodiscard]] const RunSetup& run() const { return run_; }

  /// Whether it can show one instant after another, forth and back. Otherwise it shows one alone.
  [[nodiscard]] bool canGoOn() const;

  /// @param camera  its index, and where it is instead
  /// @return CV_8UC3
  /// @throws Error where there is no such instant, or its picture is not drawn but recorded
  [[nodiscard]] cv::Mat picture(std::int64_t instant, std::size_t camera, const Pose& X_GC);

 private:
  [[nodiscard]] MotionSetup& motionOf(std::int64_t instant);

  RunSetup run_;
  std::unique_ptr<MotionRun> drawing_;  ///< of the motion that was shown last
};

}  // namespace synthetic_dataset::run
