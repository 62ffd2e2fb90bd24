#pragma once

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::programs {

/// A scene's image with its labels drawn in: masks, boxes with captions, cuboids, keypoints.
/// CV_8UC3.
/// @param scene  with visible masks
[[nodiscard]] cv::Mat pictureWithLabels(const Scene& scene);

}  // namespace synthetic_dataset::programs
