#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "world/description.h"

namespace synthetic_dataset::randomize {

/// The pictures that were used last, so that few of them are not made again and again: at most 32,
/// and 256 MB.
class RecentTextures {
 public:
  /// @param key  what the owner knows it by
  /// @param make  makes it, where it is not kept
  [[nodiscard]] std::shared_ptr<const world::Texture> get(
      std::size_t key, const std::function<world::Texture()>& make);

 private:
  struct Kept {
    std::size_t key;
    std::shared_ptr<const world::Texture> texture;
  };

  void forgetOldest();

  std::vector<Kept> kept_;  ///< the last one first
};

}  // namespace synthetic_dataset::randomize
