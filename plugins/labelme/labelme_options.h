#pragma once

#include <string>

#include "synthetic_dataset/box_choice.h"

namespace synthetic_dataset {

/// The settings of a LabelMe writer.
struct LabelMeOptions {
  bool as_rectangles = false;  ///< shapes are boxes, otherwise polygons around visible parts
  BoxChoice box = BoxChoice::kVisible;
  std::string image_format = "png";
};

[[nodiscard]] inline LabelMeOptions readLabelMeOptions(Parameters& parameters) {
  LabelMeOptions options;
  options.as_rectangles =
      parameters.optionalChoice("shape", {"polygon", "rectangle"}, "polygon") == "rectangle";
  options.box = readBoxChoice(parameters);
  options.image_format =
      parameters.optionalChoice("image_format", {"png", "jpg"}, options.image_format);
  return options;
}

}  // namespace synthetic_dataset
