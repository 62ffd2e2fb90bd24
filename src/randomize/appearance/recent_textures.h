#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "world/description.h"

namespace synthetic_dataset::randomize {

/// Caches the pictures used last, so that a small set is not made again and again: at most 32, and
/// 256 MB.
class RecentTextures {
 public:
  /// @param key  identifies the picture to the owner
  /// @param make  makes the picture if it is not cached
  [[nodiscard]] std::shared_ptr<const world::Texture> get(
      std::size_t key, const std::function<world::Texture()>& make);

 private:
  struct Kept {
    std::size_t key;
    std::shared_ptr<const world::Texture> texture;
  };

  void forgetOldest();

  std::vector<Kept> kept_;  ///< the most recent first
};

}  // namespace synthetic_dataset::randomize
