#pragma once

#include <memory>

#include <opencv2/core/mat.hpp>

#include "render/geometry/geometry_images.h"
#include "render/lens/lens_sight.h"

namespace synthetic_dataset::render {

/// The surfaces of everything that never moves, which stay the same as long as the view does.
struct StandingSurfaces {
  std::shared_ptr<const LensSight> sight;  ///< of these items only; null if they are not known
  SurfaceImages images;                    ///< of the whole picture; never written to
};

/// The surface properties of what the rays of a lens's pixels see: as the shaders compute them for
/// a pinhole camera (material.glsl), but with the means of textures over pixels. In the lens's
/// frame.
/// @param planes  which images to make
/// @param is_classic  whether backs are lit by the normals of their fronts, as in Gazebo Classic
/// @param place  of the images in the picture
/// @param wanted  CV_8UC1, of the picture: not 0 for the pixels that are looked at; all others are
///     undefined
/// @param standing  from the same view: where the same triangle is seen, it is not looked up again
[[nodiscard]] SurfaceImages surfacesOf(const LensSight& sight, const GeometryPlanes& planes,
                                       bool is_classic, const cv::Rect& place,
                                       const cv::Mat& wanted, const StandingSurfaces& standing);

}  // namespace synthetic_dataset::render
