#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "random/random_source.h"
#include "world/description.h"

namespace synthetic_dataset::appearance {

/// The pictures in a folder and in those below it, in alphabetical order.
/// @throws Error for a folder that is not there or has no picture
[[nodiscard]] std::vector<std::string> picturesIn(const std::string& folder);

/// Textures to choose from: a folder's pictures, or patterns made up.
class TextureSource {
 public:
  /// @param from  `procedural`, or a folder
  /// @throws Error for a folder that is not there or has no picture
  explicit TextureSource(const std::string& from);

  /// One of them, and its name: the picture's file, or what pattern it is.
  /// @throws Error for a picture that cannot be decoded
  [[nodiscard]] std::pair<std::string, std::shared_ptr<const world::Texture>> draw(
      random::RandomSource& random);

 private:
  [[nodiscard]] std::shared_ptr<const world::Texture> read(const std::string& file);

  std::vector<std::string> files_;  ///< in alphabetical order; none: patterns are made

  /// Those that were asked for last, so that a few pictures are not decoded again and again.
  std::vector<std::shared_ptr<const world::Texture>> recent_;
};

}  // namespace synthetic_dataset::appearance
