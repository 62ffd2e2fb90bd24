#pragma once

#include <optional>
#include <string>

#include "plugins/shared/pixel_origin.h"
#include "synthetic_dataset/box.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset {

inline constexpr int kYoloDecimals = 5;  ///< of coordinates, which are fractions of the image

/// The settings of a YOLO writer, without the list's path.
struct YoloOptions {
  bool cut_to_image = true;
  PixelOrigin origin;
  bool has_numbers = false;  ///< a label begins with its class's number, not with its text
};

[[nodiscard]] inline YoloOptions readYoloOptions(Parameters& parameters) {
  return {parameters.optional("cut_to_image", true), readPixelOrigin(parameters),
          parameters.optionalChoice("class", {"text", "number"}, "text") == "number"};
}

/// The class at the beginning of a label.
/// @param labelled  a SceneObject or the measurements of one
template <class Labelled>
[[nodiscard]] std::string yoloClass(const Labelled& labelled, const YoloOptions& options) {
  return options.has_numbers ? std::to_string(labelled.class_id) : labelled.class_text;
}

inline constexpr const char* kYoloNames = "obj.names";  ///< lists the classes, line by line from 0

/// An object's box as written to the file, relative to the configured origin; nothing if no area of
/// it is in the image. The image is assumed to begin at the origin, as in nn_data_collection, whose
/// fractions are u / width: with `centre` this is half a pixel from the first pixel's edge.
/// @param loose_box, width, height  [px]
[[nodiscard]] inline std::optional<Box> yoloBox(const Box& loose_box, const YoloOptions& options,
                                                double width, double height) {
  const Box box = options.origin.of(loose_box);
  const auto in_image = intersection(box, {0.0, 0.0, width, height});
  return in_image && !options.cut_to_image ? box : in_image;
}

}  // namespace synthetic_dataset
