#include "randomize/appearance/texture_source.h"

#include "randomize/appearance/pattern.h"
#include "randomize/appearance/picture_options.h"

namespace synthetic_dataset::randomize {

TextureSource::TextureSource(const std::string& from) {
  if (from == kNatural) {
    natural_.emplace(NaturalUse::kTexture);
  } else if (from != kProcedural) {
    pictures_.emplace(from, PictureKind::kEncoded);
  }
}

std::pair<std::string, std::shared_ptr<const world::Texture>> TextureSource::draw(
    base::RandomSource& random) {
  if (natural_) {
    auto texture = natural_->read(random.index(NaturalPool::kSize));
    return {texture->file, texture};
  }
  if (!pictures_) return drawPattern(random);
  const std::size_t index = random.index(pictures_->files().size());
  return {pictures_->files()[index], pictures_->read(index)};
}

}  // namespace synthetic_dataset::randomize
