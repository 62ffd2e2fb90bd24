#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/random/random_source.h"
#include "randomize/appearance/natural_pool.h"
#include "randomize/appearance/picture_folder.h"
#include "world/description.h"

namespace synthetic_dataset::randomize {

/// Textures to choose from: a folder's pictures, or such as are made up.
class TextureSource {
 public:
  /// @param from  `procedural` for patterns, `natural` for materials, or a folder
  /// @throws Error as PictureFolder does
  explicit TextureSource(const std::string& from);

  /// One of them, and its name: the picture's file, or what pattern it is.
  /// @throws Error for a picture that cannot be decoded
  [[nodiscard]] std::pair<std::string, std::shared_ptr<const world::Texture>> draw(
      base::RandomSource& random);

 private:
  std::optional<PictureFolder> pictures_;
  std::optional<NaturalPool> natural_;  ///< neither of both: patterns are made
};

}  // namespace synthetic_dataset::randomize
