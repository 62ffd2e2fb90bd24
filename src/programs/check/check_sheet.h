#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "run/scene_sink.h"

namespace synthetic_dataset::programs {

/// Some scenes side by side with all labels drawn in: masks, boxes with captions, cuboids,
/// keypoints; below each its name and time. CV_8UC3.
/// @param scenes  at least one, with visible masks and silhouettes
[[nodiscard]] cv::Mat checkSheet(const std::vector<run::FinishedScene>& scenes);

}  // namespace synthetic_dataset::programs
