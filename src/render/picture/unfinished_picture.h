#pragma once

#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/edges/edge_smoother.h"
#include "render/picture/light_painter.h"

namespace synthetic_dataset::render {

/// What OpenGL has drawn of a picture.
struct UnfinishedPicture {
  cv::Mat elsewhere;               ///< CV_8UC3, of the whole picture: what is not in `pixels`
  cv::Mat pixels;                  ///< CV_8UC1, of the whole picture: 255 for the other pixels
  std::vector<cv::Rect> regions;   ///< around these
  UnlitPixels unlit;               ///< them, and those by them where edges are smooth
  std::optional<EdgeScene> edges;  ///< none where they are not smoothed
};

/// @return CV_8UC3, blue green red, sRGB-encoded
[[nodiscard]] cv::Mat finished(const UnfinishedPicture& picture, const EdgeSmoother& smoother);

}  // namespace synthetic_dataset::render
