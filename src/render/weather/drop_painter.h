#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

#include "render/view.h"
#include "render/weather/precipitation.h"

namespace synthetic_dataset::render {

/// Draws what falls before a camera: each drop a streak as long as it falls while the shutter is
/// open, hidden by what is nearer. What is thinner than a pixel takes its share of the pixel. What
/// would be fainter than one grey level of 255, or is farther away than 10 m, is not drawn: it is a
/// part of the fog that rain and snow make.
///
/// The drops have their places in the global frame, so that several cameras see the same ones. The
/// lens is focused on what is far away, through an aperture of 2 mm: a drop is blurred as if
/// it were as wide as that besides. The camera stands still meanwhile.
/// @param wind_G  [m/s]
/// @param exposure  [s]
/// @param distances  CV_32FC1: as of Renderer::distances
/// @param passing  CV_32FC1 of the same size: the share of the light of what is seen that arrives;
///     multiplied by what the drops leave
void drawDrops(const Precipitation& precipitation, const Eigen::Vector3d& wind_G, double exposure,
               const View& view, std::uint64_t seed, const cv::Mat& distances, cv::Mat& passing);

}  // namespace synthetic_dataset::render
