#include "plugins/pascal_voc/pascal_voc_options.h"

#include <algorithm>

namespace synthetic_dataset {
namespace {

/// Reads a parameter that is a share from 0 to 1.
double readShare(Parameters& parameters, const std::string& name, double fallback) {
  const double share = parameters.optional(name, fallback);
  if (share < 0.0 || share > 1.0) {
    parameters.addError(name, "found " + Value(share).text() + "; it should be 0 to 1");
  }
  return share;
}

}  // namespace

PascalVocOptions readPascalVocOptions(Parameters& parameters) {
  PascalVocOptions options;
  options.box = readBoxChoice(parameters);
  options.image_format =
      parameters.optionalChoice("image_format", {"jpg", "png"}, options.image_format);
  const std::string coordinates =
      parameters.optionalChoice("coordinates", {"one_based", "zero_based"}, "one_based");
  options.first_pixel = coordinates == "one_based" ? 1 : 0;
  options.truncated_above = readShare(parameters, "truncated_above", options.truncated_above);
  options.occluded_above = readShare(parameters, "occluded_above", options.occluded_above);
  options.difficult_below = readShare(parameters, "difficult_below", options.difficult_below);
  options.segmentation = parameters.optional("segmentation", options.segmentation);
  options.void_border = parameters.optional("void_border", options.void_border);
  if (options.void_border < 0 || options.void_border > 100) {
    parameters.addError("void_border", "found " + std::to_string(options.void_border) +
                                           "; it should be 0 to 100 pixels");
  }
  return options;
}

std::string vocName(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return name;
}

}  // namespace synthetic_dataset
