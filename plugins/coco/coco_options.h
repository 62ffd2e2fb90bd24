#pragma once

#include <string>

#include "synthetic_dataset/box_choice.h"

namespace synthetic_dataset {

/// The settings of a COCO writer.
struct CocoOptions {
  bool as_polygons = false;  ///< masks are polygons, otherwise run lengths
  std::string image_format = "png";
  BoxChoice box = BoxChoice::kVisible;
  bool panoptic = false;
  bool keypoints = true;
};

[[nodiscard]] inline CocoOptions readCocoOptions(Parameters& parameters) {
  CocoOptions options;
  options.as_polygons =
      parameters.optionalChoice("segmentation", {"rle", "polygons"}, "rle") == "polygons";
  options.image_format =
      parameters.optionalChoice("image_format", {"png", "jpg"}, options.image_format);
  options.box = readBoxChoice(parameters);
  options.panoptic = parameters.optional("panoptic", options.panoptic);
  options.keypoints = parameters.optional("keypoints", options.keypoints);
  return options;
}

}  // namespace synthetic_dataset
