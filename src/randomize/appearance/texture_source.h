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

/// Textures to choose from: a folder's pictures or synthesized ones.
class TextureSource {
 public:
  /// @param from  `procedural` for patterns, `natural` for materials, or a folder
  /// @throws Error as PictureFolder does
  explicit TextureSource(const std::string& from);

  /// One of the textures and its name: the picture's file, or the kind of pattern.
  /// @throws Error if a picture cannot be decoded
  [[nodiscard]] std::pair<std::string, std::shared_ptr<const world::Texture>> draw(
      base::RandomSource& random);

 private:
  std::optional<PictureFolder> pictures_;
  std::optional<NaturalPool> natural_;  ///< if both are empty, patterns are made
};

}  // namespace synthetic_dataset::randomize
