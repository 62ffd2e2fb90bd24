#pragma once

#include <optional>
#include <string>

#include "config/config.h"
#include "motion/bag_motion.h"
#include "synthetic_dataset/camera_model.h"
#include "world/description.h"

namespace synthetic_dataset {

/// The run's camera: what it sees with, and where it is at a time.
struct CameraRig {
  CameraModel model;
  std::string frame;         ///< of the optical frame
  std::optional<Pose> X_GC;  ///< where it stands; none: its pose comes from the recording

  [[nodiscard]] bool followsRecording() const { return !X_GC.has_value(); }
};

/// Finds the intrinsics (a calibration file, else the world's sensor) and the pose (the parameter,
/// else the recording's TF, else the world's sensor).
/// @throws ErrorList naming the parameters that would mend it
[[nodiscard]] CameraRig makeCameraRig(const config::CameraConfig& config,
                                      const world::Description& world,
                                      const motion::BagMotion& recording);

}  // namespace synthetic_dataset
