#pragma once

#include <string>

#include "synthetic_dataset/box_choice.h"

namespace synthetic_dataset {

/// The settings of an ImageFolder writer.
struct ImageFolderOptions {
  std::string image_format = "png";
  BoxChoice box = BoxChoice::kVisible;
  bool masks = true;
  bool depth = false;
  bool normals = false;
  bool optical_flow = false;
  bool webdataset = false;
};

[[nodiscard]] inline ImageFolderOptions readImageFolderOptions(Parameters& parameters) {
  ImageFolderOptions options;
  options.image_format =
      parameters.optionalChoice("image_format", {"png", "jpg"}, options.image_format);
  options.box = readBoxChoice(parameters);
  options.masks = parameters.optional("masks", options.masks);
  options.depth = parameters.optional("depth", options.depth);
  options.normals = parameters.optional("normals", options.normals);
  options.optical_flow = parameters.optional("optical_flow", options.optical_flow);
  options.webdataset = parameters.optional("webdataset", options.webdataset);
  return options;
}

}  // namespace synthetic_dataset
