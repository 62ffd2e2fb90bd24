#pragma once

#include <string>

#include <opencv2/core/mat.hpp>

#include "base/scene_facts.h"

namespace synthetic_dataset::output {

using base::ContactFacts;
using base::CoverFacts;
using base::DrawFacts;
using base::KeypointFacts;
using base::ObjectFacts;
using base::PictureFacts;
using base::SceneFacts;

/// Depth is summed up in squares of so many pixels, row by row from the top left: the sum of the
/// depths, the least and the greatest [m].
constexpr int kDepthCell = 32;  // [px]

/// What the manifest has of a picture.
[[nodiscard]] PictureFacts pictureFacts(const std::string& name, const cv::Mat& pixels);

/// Unit normals as the colours of 8 bits that stand for them: red, green and blue are x, y and z
/// from -1 (0) to 1 (255); black where there is nothing.
[[nodiscard]] cv::Mat normalColours(const cv::Mat& normals);

/// Depths as whole numbers of 16 bits; 0 where they have none: behind the camera, or too far.
/// @param per_metre  how many they are in a metre
[[nodiscard]] cv::Mat depthNumbers(const cv::Mat& depth, double per_metre);

/// SHA-256 of a picture's pixels, row by row.
[[nodiscard]] std::string digestOfPixels(const cv::Mat& pixels);

}  // namespace synthetic_dataset::output
