#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/pixels/light_picture.h"

namespace synthetic_dataset::render {

/// Smaller copies of a picture, for where a pixel covers much of it. Each is half as wide and high
/// as the one before, rounded down (OpenGL 4.5, section 8.14.3), the last one pixel. A pixel is the
/// mean of what it covers: of colours, of their light. OpenGL can make them too; Mesa compiles
/// programs for that in each process, which takes longer than all pictures of a usual world.
/// @param picture  CV_8UC4: blue, green, red, alpha; or CV_32FC4, which are light
/// @return from the largest to the smallest, without the picture itself, of its type
[[nodiscard]] std::vector<cv::Mat> mipmapsOf(const cv::Mat& picture, PixelMeaning meaning);

}  // namespace synthetic_dataset::render
