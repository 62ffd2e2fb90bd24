#pragma once

#include <optional>

#include "randomize/appearance/entry_draws.h"
#include "randomize/appearance/picture_folder.h"
#include "randomize/appearance/randomize_options.h"
#include "world/look.h"

namespace synthetic_dataset::randomize {

/// Draws what is seen where nothing is: a colour, or a picture of a folder.
class BackgroundSampler {
 public:
  /// @throws ErrorList naming the entry, for a folder without pictures, pictures that cannot be
  ///     decoded, and panoramas that are not twice as wide as they are high
  explicit BackgroundSampler(const BackgroundRandomization& config);

  /// Draws a scene's background into its look.
  void sample(EntryDraws& draws, world::Look& look);

 private:
  void checkProportions() const;
  [[nodiscard]] world::BackgroundPicture drawPicture(EntryDraws& draws);

  BackgroundRandomization config_;
  std::optional<PictureFolder> pictures_;  ///< none where a colour alone is drawn
};

}  // namespace synthetic_dataset::randomize
