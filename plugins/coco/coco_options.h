#pragma once

#include <map>
#include <string>
#include <vector>

#include "synthetic_dataset/box_choice.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {

/// The settings of a COCO writer.
struct CocoOptions {
  bool as_polygons = false;  ///< masks are polygons, otherwise run-length encoded
  std::string image_format = "png";
  BoxChoice box = BoxChoice::kVisible;
  bool panoptic = false;
  std::string background;  ///< the panoptic category of the world; empty: void
  bool keypoints = true;
  std::vector<std::string> keypoint_classes;  ///< classes that have keypoints; empty: all
  bool pad_keypoints = false;                 ///< all annotations have the same number
  std::map<std::string, int> category_ids;    ///< by class; other classes have their number + 1
  std::string annotation_file = "instances";  ///< the annotation files' prefix, before the split
};

/// The prefix of the panoptic files' names, before the split's.
inline constexpr const char* kCocoPanoptic = "panoptic";

/// Reads the parameter `annotation_file`.
[[nodiscard]] inline std::string readAnnotationFile(Parameters& parameters) {
  std::string name = parameters.optional<std::string>("annotation_file", "instances");
  if (name.rfind(kCocoPanoptic, 0) == 0 || safeFileName(name) != name) {
    parameters.addError("annotation_file",
                        "found '" + name +
                            "'; it should be a name of letters, digits, _ and - such "
                            "as 'person_keypoints', and not 'panoptic'");
    name = "instances";
  }
  return name;
}

/// Reads the parameter `category_ids`. Ids start at 1 because loaders take 0 for "nothing".
[[nodiscard]] inline std::map<std::string, int> readCategoryIds(Parameters& parameters) {
  std::map<std::string, int> ids;
  Parameters given = parameters.group("category_ids");
  constexpr int kHighest = 1000000000;
  for (const std::string& name : given.names()) {
    ids[name] = given.maybeBetween(name, 1, kHighest).value_or(1);
  }
  return ids;
}

[[nodiscard]] inline CocoOptions readCocoOptions(Parameters& parameters) {
  CocoOptions options;
  options.as_polygons =
      parameters.optionalChoice("segmentation", {"rle", "polygons"}, "rle") == "polygons";
  options.image_format =
      parameters.optionalChoice("image_format", {"png", "jpg"}, options.image_format);
  options.box = readBoxChoice(parameters);
  options.panoptic = parameters.optional("panoptic", options.panoptic);
  options.background = parameters.optional("background", options.background);
  options.keypoints = parameters.optional("keypoints", options.keypoints);
  options.keypoint_classes = parameters.maybe<std::vector<std::string>>("keypoint_classes")
                                 .value_or(std::vector<std::string>());
  options.pad_keypoints = parameters.optional("pad_keypoints", options.pad_keypoints);
  options.category_ids = readCategoryIds(parameters);
  options.annotation_file = readAnnotationFile(parameters);
  return options;
}

}  // namespace synthetic_dataset
