#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/parts/draw_list.h"
#include "render/shadows/shadow_projection.h"
#include "render/view.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// Where a picture of everything may differ from a picture of what never moves, according to
/// bounds.
///
/// Each is CV_8UC1, 255 for such pixels, else 0.
struct PossibleChanges {
  cv::Mat surfaces;  ///< where opaque items that move may be seen
  cv::Mat glass;     ///< where transparent items may be seen, whether they move or not
  cv::Mat shadows;   ///< where the shadow of something that moves may be seen

  [[nodiscard]] cv::Mat all() const { return surfaces | glass | shadows; }
};

/// @param lights  of the world, to which ShadowProjection::light refers
[[nodiscard]] PossibleChanges possibleChanges(const std::vector<DrawItem>& items, const View& view,
                                              const std::vector<Pose>& X_WL,
                                              const LinkSelection& drawn,
                                              const LinkSelection& casting,
                                              const std::vector<world::Light>& lights,
                                              const std::vector<ShadowProjection>& shadows);

/// For each shadow, the links that move and may cast it onto some of the given pixels.
/// @param pixels  of the picture
[[nodiscard]] std::vector<LinkSelection> castersOnto(
    const cv::Rect& pixels, const std::vector<DrawItem>& items, const View& view,
    const std::vector<Pose>& X_WL, const LinkSelection& drawn, const LinkSelection& casting,
    const std::vector<world::Light>& lights, const std::vector<ShadowProjection>& shadows);

}  // namespace synthetic_dataset::render
