#pragma once

#include <opencv2/core/mat.hpp>

#include "render/gl/gl_object.h"

namespace synthetic_dataset::render {

/// Whether a picture has smaller copies of itself, for where a pixel covers much of it.
enum class Mipmaps { kNone, kAll };

/// A picture in the renderer's memory, filtered between its pixels; it goes on at the opposite
/// edge.
/// @param pixels  CV_8UC4: blue, green, red, alpha
/// @param format  GL_SRGB8_ALPHA8, decoded when it is read, or GL_RGBA8, read as it is
[[nodiscard]] GlTexture uploadPicture(const GlFunctions& gl, const cv::Mat& pixels, GLenum format,
                                      Mipmaps mipmaps);

}  // namespace synthetic_dataset::render
