#pragma once

#include <functional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::label {

/// The distance from the camera's centre to the surface that a pixel shows [m]; 0 if it shows
/// nothing.
using RangeAt = std::function<double(const cv::Point& pixel)>;

/// Finds out whether the camera sees each keypoint, from what it sees at the pixel nearest to the
/// keypoint.
///
/// A keypoint is hidden if something along its ray is nearer to the camera by more than the
/// tolerance. If that is the object itself, a difference that the slope of its surface explains
/// within the pixel is tolerated. So a keypoint a little below its own surface is visible; so is
/// one at the object's outline whose pixel shows what is behind it. Distances are from the camera's
/// centre, so that this also works for lenses that see past 90 degrees.
///
/// @param keypoints  with known `pixel`; their `state` is set
/// @param p_C  the keypoints' positions in the optical frame [m], in the same order
/// @param instance  the object's value in `ids`
/// @param ids  CV_32SC1 of the image's size: the instance that each pixel shows
/// @param range  of the same pixels; called for few of them
/// @param tolerance  [m]
void findKeypointStates(std::vector<Keypoint>& keypoints, const std::vector<Eigen::Vector3d>& p_C,
                        int instance, const cv::Mat& ids, const RangeAt& range,
                        const CameraModel& camera, double tolerance);

}  // namespace synthetic_dataset::label
