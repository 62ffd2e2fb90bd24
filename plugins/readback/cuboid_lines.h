#pragma once

#include <array>
#include <vector>

#include <opencv2/core/types.hpp>

#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/cuboid.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::formats {

/// The edges of an object's cuboid as projected by the camera [px], in short pieces because lenses
/// bend them. Pieces that do not project onto the image plane are left out.
[[nodiscard]] std::vector<std::array<cv::Point2d, 2>> cuboidLines(const Cuboid& cuboid_O,
                                                                  const Pose& X_CO,
                                                                  const CameraModel& camera);

}  // namespace synthetic_dataset::formats
