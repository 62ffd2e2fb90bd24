#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/pixels/light_picture.h"

namespace synthetic_dataset::render {

/// The mipmap levels of a picture. Each is half as wide and high as the one before, rounded down
/// (OpenGL 4.5, section 8.14.3); the last is a single pixel. A pixel is the mean of what it covers;
/// for colours, of their linear light. OpenGL can make them too, but Mesa then compiles programs
/// for that in each process, which takes longer than making them here for all pictures of a usual
/// world.
/// @param picture  CV_8UC4: blue, green, red, alpha; or CV_32FC4, which is linear light
/// @return from the largest to the smallest, without the picture itself, and of its type
[[nodiscard]] std::vector<cv::Mat> mipmapsOf(const cv::Mat& picture, PixelMeaning meaning);

}  // namespace synthetic_dataset::render
