#pragma once

namespace synthetic_dataset::world {

/// What becomes of a world that names a file which is not there, or cannot be read: it is refused,
/// or loaded without what needs the file.
enum class OnMissingAsset { kError, kWarn };

/// What files do not say.
struct LoadOptions {
  OnMissingAsset on_missing_asset = OnMissingAsset::kError;
};

}  // namespace synthetic_dataset::world
