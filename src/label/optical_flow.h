#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/view.h"
#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::label {

/// Where what each pixel's centre sees has moved to, minus where it was [px]: CV_32FC2 (u, v). A
/// point of a surface rides on its link, and the camera moves too. The place may be outside of the
/// image, or hidden there. NaN where nothing is seen, or the point comes to where the camera cannot
/// project it.
///
/// @param depth  CV_32FC1: z of what is seen, in the optical frame [m]; all of the image's size
/// @param range  CV_32FC1: its distance from the camera [m]; or empty, where all z are above 0
/// @param links  CV_32SC1: its link's index + 1, 0 where nothing is seen
/// @param camera, X_WC, X_WL  the camera, and where it and the links are at the pixels' time
/// @param camera_next, X_WC_next, X_WL_next  and at the other one
[[nodiscard]] cv::Mat opticalFlow(const CameraModel& camera, const cv::Mat& depth,
                                  const cv::Mat& range, const cv::Mat& links, const Pose& X_WC,
                                  const std::vector<Pose>& X_WL, const CameraModel& camera_next,
                                  const Pose& X_WC_next, const std::vector<Pose>& X_WL_next);

/// The same of pictures whose rows are taken one after the other: from where the pixel's row has
/// the point to where the next picture has it.
/// @param rows, next  the picture and the next one, with the world's links
[[nodiscard]] cv::Mat opticalFlow(const render::RollingView& rows, const cv::Mat& range,
                                  const cv::Mat& links, const render::RollingView& next);

}  // namespace synthetic_dataset::label
