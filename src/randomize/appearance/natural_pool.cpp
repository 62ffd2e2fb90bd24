#include "randomize/appearance/natural_pool.h"

#include <array>
#include <cstdint>
#include <string>

#include "base/random/random_source.h"
#include "randomize/appearance/natural_picture.h"
#include "randomize/appearance/picture_options.h"

namespace synthetic_dataset::randomize {
namespace {

NaturalPicture drawPoolPicture(NaturalUse use, std::size_t index) {
  const auto number = static_cast<std::int64_t>(index);
  if (use == NaturalUse::kTexture) {
    base::RandomSource random(0, number, "natural texture");
    const int side = random.index(3) == 0 ? 256 : 512;
    return drawNaturalTexture(random, side);
  }
  base::RandomSource random(0, number, "natural background");
  constexpr std::array<std::array<int, 2>, 4> kSizes = {
      {{640, 480}, {576, 432}, {512, 384}, {416, 312}}};
  const std::array<int, 2>& size = kSizes[random.index(kSizes.size())];
  return drawNaturalPicture(random, size[0], size[1]);
}

}  // namespace

std::shared_ptr<const world::Texture> NaturalPool::read(std::size_t index) {
  return recent_.get(index, [&] {
    NaturalPicture picture = drawPoolPicture(use_, index);
    const std::string name = std::string(kNatural) + "/" + picture.kind + "/";
    return world::Texture{name + std::to_string(index), picture.pixels};
  });
}

}  // namespace synthetic_dataset::randomize
