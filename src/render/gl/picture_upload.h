#pragma once

#include <opencv2/core/mat.hpp>

#include "render/gl/gl_object.h"
#include "render/pixels/light_picture.h"

namespace synthetic_dataset::render {

/// Whether a picture has smaller copies of itself, for where a pixel covers much of it.
enum class Mipmaps { kNone, kAll };

/// A picture in the renderer's memory, filtered between its pixels; it goes on at the opposite
/// edge.
/// @param pixels  CV_8UC4: blue, green, red, alpha; or CV_32FC4, linear light, which is kept with
/// 16
///     bits a number
[[nodiscard]] GlTexture uploadPicture(const GlFunctions& gl, const cv::Mat& pixels,
                                      PixelMeaning meaning, Mipmaps mipmaps);

}  // namespace synthetic_dataset::render
