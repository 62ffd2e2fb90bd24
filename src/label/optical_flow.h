#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/view.h"
#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::label {

/// The image motion of the point that each pixel's centre sees, new position minus old [px]:
/// CV_32FC2 (u, v). A point of a surface moves with its link, and the camera moves too. The new
/// position may be outside the image, or hidden there. NaN where nothing is seen, or where the
/// camera cannot project the point afterwards.
///
/// @param depth  CV_32FC1: z of the seen points, in the optical frame [m]; like `range` and
///     `links`, of the image's size
/// @param range  CV_32FC1: their distances from the camera [m]; may be empty if all z are above 0
/// @param links  CV_32SC1: their links' indices + 1, 0 where nothing is seen
/// @param camera, X_WC, X_WL  the camera, and the poses of it and of the links at the pixels' time
/// @param camera_next, X_WC_next, X_WL_next  the same at the other time
[[nodiscard]] cv::Mat opticalFlow(const CameraModel& camera, const cv::Mat& depth,
                                  const cv::Mat& range, const cv::Mat& links, const Pose& X_WC,
                                  const std::vector<Pose>& X_WL, const CameraModel& camera_next,
                                  const Pose& X_WC_next, const std::vector<Pose>& X_WL_next);

/// The same for pictures whose rows are taken one after the other: from the point's position in the
/// pixel's row to its position in the next picture.
/// @param rows, next  the picture and the next one, with the world's links
[[nodiscard]] cv::Mat opticalFlow(const render::RollingView& rows, const cv::Mat& range,
                                  const cv::Mat& links, const render::RollingView& next);

}  // namespace synthetic_dataset::label
