#pragma once

#include <cstddef>
#include <memory>

#include "randomize/appearance/recent_textures.h"
#include "world/description.h"

namespace synthetic_dataset::randomize {

/// What pictures are used for.
enum class NaturalUse { kTexture, kBackground };

/// Pictures with the statistics of photographs. Each depends only on its number, so that all runs
/// share the same ones, and only those that are drawn are made.
class NaturalPool {
 public:
  static constexpr std::size_t kSize = 256;

  explicit NaturalPool(NaturalUse use) : use_(use) {}

  /// A picture; its file is just a name: "natural/brick/17".
  /// @param index  less than kSize
  [[nodiscard]] std::shared_ptr<const world::Texture> read(std::size_t index);

 private:
  NaturalUse use_;
  RecentTextures recent_;
};

}  // namespace synthetic_dataset::randomize
