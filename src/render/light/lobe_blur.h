#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// Ever smaller copies of a panorama, each half as wide and high as the one before, whose pixels
/// are means of what they cover.
/// @param panorama  CV_32FC4: equirectangular, linear
/// @return that itself first
[[nodiscard]] std::vector<cv::Mat> smallerPanoramas(const cv::Mat& panorama);

/// What a rough surface mirrors of a panorama, for each direction of a mirror: the mean over GGX's
/// lobe, by the cosine to the surface, of one that is looked at head-on (Karis 2013, "Real Shading
/// in Unreal Engine 4"). The lobe is cut into rings of equal weight and these into cells, each of
/// which is looked up where a copy's pixels are as large (after Krivanek and Colbert 2008,
/// "Real-time Shading with Filtered Importance Sampling", with places that are not random).
/// @param smaller  of smallerPanoramas()
/// @param alpha  GGX's: the square of a roughness, > 0
/// @return CV_32FC4: equirectangular as well, twice as wide as high
[[nodiscard]] cv::Mat blurredByLobe(const std::vector<cv::Mat>& smaller, double alpha, int rows);

}  // namespace synthetic_dataset::render
