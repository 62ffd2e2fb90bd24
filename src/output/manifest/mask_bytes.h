#pragma once

#include <string>
#include <string_view>

#include "synthetic_dataset/mask.h"

namespace synthetic_dataset::output {

/// A mask as stored in the manifest, in LEB128 numbers: 7 bits per byte, lowest first, the top bit
/// set if the number continues. First left, top, width and height of the box around the mask's
/// pixels; then, row by row through that box, run lengths: pixels off the mask, on it, off it and
/// so on.
[[nodiscard]] std::string maskBytes(const Mask& mask);

/// Decodes the mask of an image of this size.
/// @throws Error if the bytes are not such a mask
[[nodiscard]] Mask maskOfBytes(std::string_view bytes, const cv::Size& image_size);

}  // namespace synthetic_dataset::output
