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

/// Draws what is seen where nothing is: a colour, or a picture, of a folder or made up.
class BackgroundSampler {
 public:
  /// @throws ErrorList naming the entry, for a folder without pictures, pictures that cannot be
  ///     decoded, and panoramas that are not twice as wide as they are high
  explicit BackgroundSampler(const BackgroundRandomization& config);

  /// Draws a scene's background into its look.
  void sample(EntryDraws& draws, world::Look& look);

 private:
  void checkProportions() const;
  [[nodiscard]] std::shared_ptr<const world::Texture> readPicture(base::RandomSource& random);
  [[nodiscard]] world::BackgroundPicture drawPicture(EntryDraws& draws);

  BackgroundRandomization config_;
  /// Neither of both where a colour alone is drawn.
  std::optional<PictureFolder> pictures_;
  std::optional<NaturalPool> natural_;
};

}  // namespace synthetic_dataset::randomize
