#pragma once

#include <memory>
#include <optional>

#include "base/random/random_source.h"
#include "randomize/appearance/entry_draws.h"
#include "randomize/appearance/natural_pool.h"
#include "randomize/appearance/picture_folder.h"
#include "randomize/appearance/randomize_options.h"
#include "world/look.h"

namespace synthetic_dataset::randomize {

/// Draws the background: a colour, or a picture from a folder or synthesized.
class BackgroundSampler {
 public:
  /// @throws ErrorList naming the entry if a folder has no pictures, pictures cannot be decoded, or
  ///     panoramas are not twice as wide as high
  explicit BackgroundSampler(const BackgroundRandomization& config);

  /// Draws a scene's background into its look.
  void sample(EntryDraws& draws, world::Look& look);

 private:
  void checkProportions() const;
  [[nodiscard]] std::shared_ptr<const world::Texture> readPicture(base::RandomSource& random);
  [[nodiscard]] world::BackgroundPicture drawPicture(EntryDraws& draws);

  BackgroundRandomization config_;
  /// Both empty if only a colour is drawn.
  std::optional<PictureFolder> pictures_;
  std::optional<NaturalPool> natural_;
};

}  // namespace synthetic_dataset::randomize
