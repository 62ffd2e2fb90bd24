#pragma once

#include <string>
#include <string_view>

#include "synthetic_dataset/mask.h"

namespace synthetic_dataset::output {

/// A mask as the manifest holds it: numbers of 7 bits a byte, the lowest first, with the highest
/// bit set where the number goes on (LEB128). First left, top, width and height of the box around
/// its pixels; then, row by row through that box, how many pixels are off it, on it, off it and so
/// on.
[[nodiscard]] std::string maskBytes(const Mask& mask);

/// The mask of an image of this size.
/// @throws Error where the bytes are none of such a mask
[[nodiscard]] Mask maskOfBytes(std::string_view bytes, const cv::Size& image_size);

}  // namespace synthetic_dataset::output
