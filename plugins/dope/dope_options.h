#pragma once

#include "synthetic_dataset/box_choice.h"

namespace synthetic_dataset {

/// The dialects of one format. In both, locations are in the camera's frame.
enum class DopeStyle {
  kDope,  ///< DOPE's own generators: metres, the centre as the ninth point
  kNdds,  ///< NVIDIA's Unreal plugin: centimetres, the centre as a separate member
};

/// The settings of a DOPE writer.
struct DopeOptions {
  DopeStyle style = DopeStyle::kDope;
  BoxChoice box = BoxChoice::kVisible;
};

[[nodiscard]] inline DopeOptions readDopeOptions(Parameters& parameters) {
  const bool is_ndds = parameters.optionalChoice("style", {"dope", "ndds"}, "dope") == "ndds";
  return {is_ndds ? DopeStyle::kNdds : DopeStyle::kDope, readBoxChoice(parameters)};
}

}  // namespace synthetic_dataset
