#pragma once

#include <string>

#include "synthetic_dataset/box_choice.h"

namespace synthetic_dataset {

inline constexpr int kFractionDecimals = 8;

/// How far an outline stays away from its pixels' edges [px], so that it does not enter the next
/// pixel even after rounding to float.
inline constexpr double kOutlineMargin = 0.01;

/// The settings of an Ultralytics writer, without the keypoints'.
struct UltralyticsOptions {
  std::string task;  ///< detect, segment, pose or obb
  std::string image_format = "png";
  BoxChoice box = BoxChoice::kVisible;  ///< for detect and pose
  bool is_whole = false;                ///< for segment and obb: the mask is the silhouette

  [[nodiscard]] bool hasBoxes() const { return task == "detect" || task == "pose"; }
};

[[nodiscard]] inline UltralyticsOptions readUltralyticsOptions(Parameters& parameters) {
  UltralyticsOptions options;
  options.task = parameters.requiredChoice("task", {"detect", "segment", "pose", "obb"});
  options.image_format =
      parameters.optionalChoice("image_format", {"png", "jpg"}, options.image_format);
  if (options.hasBoxes()) options.box = readBoxChoice(parameters);
  if (options.task == "segment" || options.task == "obb") {
    options.is_whole =
        parameters.optionalChoice("mask", {"visible", "silhouette"}, "visible") == "silhouette";
  }
  return options;
}

}  // namespace synthetic_dataset
