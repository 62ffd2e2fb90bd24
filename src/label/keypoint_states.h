#pragma once

#include <functional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::label {

/// At what distance from the camera's centre a pixel's own surface is [m], 0 where nothing is.
using RangeAt = std::function<double(const cv::Point& pixel)>;

/// Finds what the camera sees of each keypoint in what it sees at the pixel nearest to it.
///
/// A keypoint is hidden where something is nearer to the camera along its ray, by more than the
/// tolerance. Where that is the object itself, what the surface's slope accounts for within the
/// pixel is let through. So one a little below its own surface is visible; so is one whose pixel
/// shows what is behind it, at the object's outline. Distances are from the camera's centre, so
/// that it holds for lenses that see past 90 degrees.
///
/// @param keypoints  their `pixel` is known; their `state` is set
/// @param p_C  where they are in the optical frame [m], in the same order
/// @param instance  the object's value in `ids`
/// @param ids  CV_32SC1 of the image's size: whom each pixel sees
/// @param range  of the same pixels; asked for few of them
/// @param tolerance  [m]
void findKeypointStates(std::vector<Keypoint>& keypoints, const std::vector<Eigen::Vector3d>& p_C,
                        int instance, const cv::Mat& ids, const RangeAt& range,
                        const CameraModel& camera, double tolerance);

}  // namespace synthetic_dataset::label
