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

/// Depth is summarized in square cells of this size, row by row from the top left: the sum of the
/// depths, the least and the greatest [m].
constexpr int kDepthCell = 32;  // [px]

/// The facts that the manifest records about a picture.
[[nodiscard]] PictureFacts pictureFacts(const std::string& name, const cv::Mat& pixels);

/// Encodes unit normals as 8-bit colours: red, green and blue are x, y and z from -1 (0) to 1
/// (255); black where there is no surface.
[[nodiscard]] cv::Mat normalColours(const cv::Mat& normals);

/// Depths as 16-bit integers; 0 for none: behind the camera, or too far.
/// @param per_metre  number of units per metre
[[nodiscard]] cv::Mat depthNumbers(const cv::Mat& depth, double per_metre);

/// SHA-256 of a picture's pixels, row by row.
[[nodiscard]] std::string digestOfPixels(const cv::Mat& pixels);

}  // namespace synthetic_dataset::output
