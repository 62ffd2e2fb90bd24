#include "plugins/bop/bop_options.h"

#include <algorithm>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
namespace {

/// A tenth of a millimetre if that reaches the far plane, as in BOP's rendered images; otherwise a
/// millimetre, as for most depth cameras.
double depthScaleFor(const DatasetInfo& dataset) {
  constexpr double kMillimetresOfAMetre = 1000.0;
  constexpr double kGreatest = 65535.0;  // maximum value of a pixel
  constexpr double kFine = 0.1;
  double far = 0.0;
  for (const CameraDescription& camera : dataset.cameras) far = std::max(far, camera.model.far());
  return far * kMillimetresOfAMetre <= kFine * kGreatest ? kFine : 1.0;
}

}  // namespace

BopOptions readBopOptions(Parameters& parameters, const DatasetInfo& dataset) {
  BopOptions options;
  const auto type = parameters.optional<std::string>("train_type", "");
  if (!type.empty()) options.train_folder += "_" + safeFileName(type);
  options.images_per_scene = parameters.optional("images_per_scene", options.images_per_scene);
  if (options.images_per_scene < 1) {
    parameters.addError("images_per_scene", "found " + std::to_string(options.images_per_scene) +
                                                "; it should be a whole number from 1");
    options.images_per_scene = 1;
  }
  options.depth_scale = parameters.optional("depth_scale", depthScaleFor(dataset));
  if (!(options.depth_scale > 0.0)) {
    parameters.addError("depth_scale", "found " + Value(options.depth_scale).text() +
                                           "; it should be greater than 0 [mm]");
    options.depth_scale = 1.0;
  }
  options.coco = parameters.optional("coco", options.coco);
  if (parameters.has("image_format")) {
    options.image_format = options.train_format =
        "." + parameters.requiredChoice("image_format", {"png", "jpg"});
  } else if (type == "pbr") {
    options.train_format = ".jpg";  // as expected in train_pbr by bop_toolkit's dataset_params.py
  }
  return options;
}

}  // namespace synthetic_dataset
