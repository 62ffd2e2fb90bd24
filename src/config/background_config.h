#pragma once

#include <optional>
#include <string>

#include "random/distribution.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {

/// How a picture lies behind the world.
enum class BackgroundProjection {
  kBackdrop,  ///< it fills every image, whatever the camera looks at
  kPanorama,  ///< it lies round the world: equirectangular, all of the sky and the ground
};

/// Pictures of which one is seen where nothing is.
struct BackgroundPictures {
  std::string folder;             ///< absolute
  std::optional<double> present;  ///< how likely there is one, 0 .. 1; nothing: always
  BackgroundProjection projection = BackgroundProjection::kBackdrop;
  std::optional<random::Distribution> yaw;  ///< of a panorama: where its middle lies, from x to y
                                            ///< of the global frame [rad]; nothing: along x
  std::optional<random::Distribution> brightness;  ///< times the picture's light, >= 0
};

/// What is drawn anew of what is seen where nothing is; nothing: as the world has it.
struct BackgroundRandomization {
  /// sRGB-encoded red, green, blue, 0 .. 1; beside pictures, of the scenes without one.
  std::optional<random::Distribution> colour;
  std::string colour_name = "background";  ///< of its entry, below `randomize`
  std::optional<BackgroundPictures> pictures;
};

/// Reads `background` of `randomize`: a colour, or a group with `colour`, `pictures` and what
/// belongs to these.
[[nodiscard]] BackgroundRandomization readBackground(Parameters randomize);

}  // namespace synthetic_dataset::config
