#pragma once

#include <memory>

#include <opencv2/core/mat.hpp>

#include "render/geometry/geometry_images.h"
#include "render/lens/lens_sight.h"

namespace synthetic_dataset::render {

/// The surfaces of what never moves, which stay as they are while the view does.
struct StandingSurfaces {
  std::shared_ptr<const LensSight> sight;  ///< of nothing else; null where they are not known
  SurfaceImages images;                    ///< of the whole picture; never written to
};

/// What light makes of what the rays of a lens's pixels see: as the shaders have it for a pinhole's
/// (material.glsl), but with the means of textures over pixels. In the lens's frame.
/// @param planes  which images there are
/// @param is_classic  whether backs are lit by the normals of their fronts, as in Gazebo Classic
/// @param place  of the images in the picture
/// @param wanted  CV_8UC1 of the picture: not 0 for the pixels that are looked at; of others
///     nothing is sure
/// @param standing  from the same view: where the same is seen, it is not looked up again
[[nodiscard]] SurfaceImages surfacesOf(const LensSight& sight, const GeometryPlanes& planes,
                                       bool is_classic, const cv::Rect& place,
                                       const cv::Mat& wanted, const StandingSurfaces& standing);

}  // namespace synthetic_dataset::render
