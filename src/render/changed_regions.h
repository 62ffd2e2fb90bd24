#pragma once

#include <vector>

#include <opencv2/core/types.hpp>

#include "render/draw_list.h"
#include "render/light_setup.h"
#include "render/view.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// Where a picture of what never moves differs from one with all else: rectangles of pixels, which
/// may overlap, some larger than need be.
struct ChangedRegions {
  std::vector<cv::Rect> shadowed;  ///< where what never moves may be in the shadow of what moves
  std::vector<cv::Rect> covered;   ///< where what moves, or what one can see through, may be seen
};

/// @param lights  of the world, to which ShadowProjection::light refers
[[nodiscard]] ChangedRegions changedRegions(const std::vector<Part>& parts, const View& view,
                                            const std::vector<Pose>& X_WL,
                                            const LinkSelection& drawn,
                                            const LinkSelection& casting,
                                            const std::vector<world::Light>& lights,
                                            const std::vector<ShadowProjection>& shadows);

}  // namespace synthetic_dataset::render
