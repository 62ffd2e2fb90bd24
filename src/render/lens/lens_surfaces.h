#pragma once

#include <opencv2/core/mat.hpp>

#include "render/geometry/geometry_images.h"
#include "render/lens/lens_sight.h"

namespace synthetic_dataset::render {

/// What light makes of what the rays of a lens's pixels see: as the shaders have it for a pinhole's
/// (material.glsl), but with the means of textures over pixels. In the lens's frame.
/// @param planes  which images there are
/// @param is_classic  whether backs are lit by the normals of their fronts, as in Gazebo Classic
/// @param place  of the images in the picture
/// @param wanted  CV_8UC1 of the picture: not 0 for the pixels that are looked at; of others
///     nothing is sure
[[nodiscard]] SurfaceImages surfacesOf(const LensSight& sight, const GeometryPlanes& planes,
                                       bool is_classic, const cv::Rect& place,
                                       const cv::Mat& wanted);

}  // namespace synthetic_dataset::render
