#include "randomize/appearance/recent_textures.h"

#include <algorithm>
#include <cstddef>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::randomize {
namespace {

std::size_t memoryOf(const world::Texture& texture) {
  return texture.pixels.total() * texture.pixels.elemSize();
}

}  // namespace

std::shared_ptr<const world::Texture> RecentTextures::get(
    std::size_t key, const std::function<world::Texture()>& make) {
  auto found =
      std::find_if(kept_.begin(), kept_.end(), [&](const Kept& each) { return each.key == key; });
  if (found == kept_.end()) {
    found = kept_.insert(kept_.begin(), {key, std::make_shared<world::Texture>(make())});
  }
  std::rotate(kept_.begin(), found, found + 1);
  forgetOldest();
  return kept_.front().texture;
}

void RecentTextures::forgetOldest() {
  constexpr std::size_t kMost = 32;
  constexpr std::size_t kMemory = 256U << 20U;  // [byte]
  std::size_t memory = 0;
  std::size_t count = 0;
  for (const Kept& each : kept_) {
    memory += memoryOf(*each.texture);
    if (count > 0 && (count == kMost || memory > kMemory)) break;
    ++count;
  }
  kept_.resize(count);
}

}  // namespace synthetic_dataset::randomize
