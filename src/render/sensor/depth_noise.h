#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

#include "render/sensor/sensor_options.h"
#include "synthetic_dataset/camera_model.h"

/// What depth cameras measure. Both models take the picture for a rectified one of the camera's
/// focal length, and its other view to lie a baseline away along x.
namespace synthetic_dataset::render {

/// Standard deviation of the depth that a Kinect measures [m], by depth [m] and angle between ray
/// and normal [rad] (Nguyen, Izadi and Lovell 2012, Modeling Kinect Sensor Noise for Improved 3D
/// Reconstruction and Tracking, eq. 4).
[[nodiscard]] double kinectAxialNoise(double depth, double angle);

/// The same along the image [px] (eq. 1 there).
[[nodiscard]] double kinectLateralNoise(double angle);

/// A depth picture as the camera measures it; what it cannot measure is 0.
///
/// Structured light: a pixel's depth is that of a place beside it, by the lateral noise, and
/// differs by the axial noise. It is rounded to a step of disparity (Khoshelham and Elberink 2012,
/// Accuracy and Resolution of Kinect Depth Data, eq. 5 and 11; the axial noise that was measured
/// has that rounding in it, so the rest is added). Nothing is measured where the projector's light
/// does not fall, at grazing angles, out of range, and at half the pixels beside an edge.
///
/// Stereo: the disparity fb/z has normal noise and is rounded, so that the depth's standard
/// deviation is z^2 / fb times the disparity's (Matthies and Shafer 1987, Error Modeling in Stereo
/// Navigation). Nothing is measured where the second camera sees something nearer, to the left of
/// near objects, and in the strip on the left that is out of its picture.
/// @param depth  CV_32FC1, z [m]; 0 for nothing
/// @param seed  of the noise: the same seed gives the same picture
[[nodiscard]] cv::Mat measuredDepth(const cv::Mat& depth, const CameraModel& camera,
                                    const DepthNoise& noise, std::uint64_t seed);

}  // namespace synthetic_dataset::render
