#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

#include "render/sensor/sensor_options.h"
#include "synthetic_dataset/camera_model.h"

/// What depth cameras measure. Both models assume that the picture is rectified and has the
/// camera's focal length, and that the second view lies a baseline away along x.
namespace synthetic_dataset::render {

/// Standard deviation of the depth that a Kinect measures [m], by depth [m] and angle between ray
/// and normal [rad] (Nguyen, Izadi and Lovell 2012, Modeling Kinect Sensor Noise for Improved 3D
/// Reconstruction and Tracking, eq. 4).
[[nodiscard]] double kinectAxialNoise(double depth, double angle);

/// The standard deviation of the position in the image [px] (eq. 1 of the same paper).
[[nodiscard]] double kinectLateralNoise(double angle);

/// The depth picture as the camera measures it; what it cannot measure is 0.
///
/// Structured light: a pixel takes its depth from a place nearby, displaced by the lateral noise,
/// and axial noise is added to it. The result is rounded to a step of disparity (Khoshelham and
/// Elberink 2012, Accuracy and Resolution of Kinect Depth Data, eq. 5 and 11; the measured axial
/// noise includes that rounding, so only the rest is added). Nothing is measured where the
/// projector's light does not fall, at grazing angles, out of range, and at half the pixels beside
/// an edge.
///
/// Stereo: normal noise is added to the disparity fb/z, which is then rounded, so that the depth's
/// standard deviation is z^2 / fb times the disparity's (Matthies and Shafer 1987, Error Modeling
/// in Stereo Navigation). Nothing is measured where the second camera sees something nearer, to the
/// left of near objects, and in the strip on the left that is outside its picture.
/// @param depth  CV_32FC1, z [m]; 0 for nothing
/// @param seed  of the noise: the same seed gives the same picture
[[nodiscard]] cv::Mat measuredDepth(const cv::Mat& depth, const CameraModel& camera,
                                    const DepthNoise& noise, std::uint64_t seed);

}  // namespace synthetic_dataset::render
