#pragma once

#include <optional>

#include "synthetic_dataset/box.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset {

inline constexpr int kYoloDecimals = 5;  ///< of a fraction of the image

/// The settings of a YOLO writer, without the list's path.
struct YoloOptions {
  bool cut_to_image = true;
};

[[nodiscard]] inline YoloOptions readYoloOptions(Parameters& parameters) {
  return {parameters.optional("cut_to_image", true)};
}

/// An object's box; nothing where no area of it is in the image. As in nn_data_collection, whose
/// fractions are u / width, the image is taken to begin at its first pixel's centre, half a pixel
/// off the pixel's edge.
/// @param loose_box, width, height  [px]
[[nodiscard]] inline std::optional<Box> yoloBox(const Box& loose_box, const YoloOptions& options,
                                                double width, double height) {
  const auto in_image = intersection(loose_box, {0.0, 0.0, width, height});
  return in_image && !options.cut_to_image ? loose_box : in_image;
}

}  // namespace synthetic_dataset
