#pragma once

#include "world/files/findings.h"

namespace synthetic_dataset::world {

/// What files do not say.
struct LoadOptions {
  double default_near = 0.05;   ///< of the world's cameras [m]
  double default_far = 1000.0;  ///< of the world's cameras [m]
  OnMissingAsset on_missing_asset = OnMissingAsset::kError;
};

}  // namespace synthetic_dataset::world
