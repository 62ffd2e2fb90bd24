#pragma once

#include <opencv2/core/mat.hpp>

#include "render/gl/gl_object.h"
#include "render/pixels/light_picture.h"

namespace synthetic_dataset::render {

/// Whether a texture has mipmaps.
enum class Mipmaps { kNone, kAll };

/// Uploads a picture as a texture with linear filtering that repeats beyond its edges.
/// @param pixels  CV_8UC4: blue, green, red, alpha; or CV_32FC4: linear light, which is stored with
///   16 bits per channel
[[nodiscard]] GlTexture uploadPicture(const GlFunctions& gl, const cv::Mat& pixels,
                                      PixelMeaning meaning, Mipmaps mipmaps);

}  // namespace synthetic_dataset::render
