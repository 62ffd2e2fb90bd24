#pragma once

#include <cstddef>
#include <memory>

#include "randomize/appearance/recent_textures.h"
#include "world/description.h"

namespace synthetic_dataset::randomize {

/// What pictures are for.
enum class NaturalUse { kTexture, kBackground };

/// Pictures with the statistics of photographs. Each follows from its number alone, so all runs
/// have the same, and only those are made that are drawn.
class NaturalPool {
 public:
  static constexpr std::size_t kSize = 256;

  explicit NaturalPool(NaturalUse use) : use_(use) {}

  /// A picture; its file is a name: "natural/brick/17".
  /// @param index  below kSize
  [[nodiscard]] std::shared_ptr<const world::Texture> read(std::size_t index);

 private:
  NaturalUse use_;
  RecentTextures recent_;
};

}  // namespace synthetic_dataset::randomize
