#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/draw_list.h"
#include "render/light_setup.h"
#include "render/view.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// Where what moves may be seen: rectangles of pixels, which may overlap, some larger than need be.
[[nodiscard]] std::vector<cv::Rect> movingRegions(const std::vector<Part>& parts, const View& view,
                                                  const std::vector<Pose>& X_WL,
                                                  const LinkSelection& drawn);

/// Where a picture of what never moves, and hides what is behind it, may differ from one with all
/// else: where that, or its shadow, may be seen.
/// @param lights  of the world, to which ShadowProjection::light refers
/// @return CV_8UC1, 255 for such pixels, else 0
[[nodiscard]] cv::Mat changedPixels(const std::vector<Part>& parts, const View& view,
                                    const std::vector<Pose>& X_WL, const LinkSelection& drawn,
                                    const LinkSelection& casting,
                                    const std::vector<world::Light>& lights,
                                    const std::vector<ShadowProjection>& shadows);

}  // namespace synthetic_dataset::render
