#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

#include "render/view.h"
#include "render/weather/precipitation.h"

namespace synthetic_dataset::render {

/// Draws what falls in front of a camera: each drop as a streak as long as its path while the
/// shutter is open, hidden by what is nearer. A streak thinner than a pixel takes its share of the
/// pixel. Drops that would be fainter than one grey level of 255, or are farther away than 10 m,
/// are not drawn: they are a part of the fog that rain and snow make.
///
/// The drops have their places in the global frame, so that several cameras see the same ones. The
/// lens is focused at infinity and has an aperture of 2 mm: a drop is blurred by a disc of that
/// width at the drop's distance. The camera is taken to stand still meanwhile.
/// @param wind_G  [m/s]
/// @param exposure  [s]
/// @param distances  CV_32FC1: as from Renderer::distances()
/// @param passing  CV_32FC1 of the same size: the share of light that arrives from what is seen; is
///     multiplied by the share that the drops let pass
void drawDrops(const Precipitation& precipitation, const Eigen::Vector3d& wind_G, double exposure,
               const View& view, std::uint64_t seed, const cv::Mat& distances, cv::Mat& passing);

}  // namespace synthetic_dataset::render
