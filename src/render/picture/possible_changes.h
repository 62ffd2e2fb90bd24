#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/parts/draw_list.h"
#include "render/shadows/shadow_projection.h"
#include "render/view.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// Where a picture of what never moves may differ from one with all else, from bounds alone.
///
/// Each is CV_8UC1, 255 for such pixels, else 0.
struct PossibleChanges {
  cv::Mat surfaces;  ///< what moves may be seen there
  cv::Mat glass;     ///< and there what one can see through, whether it moves or not
  cv::Mat shadows;   ///< and there the shadow of what moves

  [[nodiscard]] cv::Mat all() const { return surfaces | glass | shadows; }
};

/// @param lights  of the world, to which ShadowProjection::light refers
[[nodiscard]] PossibleChanges possibleChanges(const std::vector<DrawItem>& items, const View& view,
                                              const std::vector<Pose>& X_WL,
                                              const LinkSelection& drawn,
                                              const LinkSelection& casting,
                                              const std::vector<world::Light>& lights,
                                              const std::vector<ShadowProjection>& shadows);

/// For each shadow, the links that move and may cast it on some of these pixels.
/// @param pixels  of the picture
[[nodiscard]] std::vector<LinkSelection> castersOnto(
    const cv::Rect& pixels, const std::vector<DrawItem>& items, const View& view,
    const std::vector<Pose>& X_WL, const LinkSelection& drawn, const LinkSelection& casting,
    const std::vector<world::Light>& lights, const std::vector<ShadowProjection>& shadows);

}  // namespace synthetic_dataset::render
