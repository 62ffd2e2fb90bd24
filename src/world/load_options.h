#pragma once

#include "world/files/findings.h"

namespace synthetic_dataset::world {

/// What files do not say.
struct LoadOptions {
  OnMissingAsset on_missing_asset = OnMissingAsset::kError;
};

}  // namespace synthetic_dataset::world
