#pragma once

#include <string>

#include "synthetic_dataset/box_choice.h"

namespace synthetic_dataset {

/// The settings of a Pascal VOC writer.
struct PascalVocOptions {
  BoxChoice box = BoxChoice::kVisible;
  std::string image_format = "jpg";
  int first_pixel = 1;            ///< index of the first pixel of a row or column
  double truncated_above = 0.05;  ///< share of the silhouette outside the image
  double occluded_above = 0.05;   ///< share of the silhouette in the image that is hidden
  double difficult_below = 0.2;   ///< visibility
  bool segmentation = true;       ///< whether to write pictures of classes and objects
  int void_border = 0;            ///< [px]
};

[[nodiscard]] PascalVocOptions readPascalVocOptions(Parameters& parameters);

/// A name that is valid in XML: spaces in place of control characters.
/// https://www.w3.org/TR/xml/#charsets
[[nodiscard]] std::string vocName(std::string name);

}  // namespace synthetic_dataset
