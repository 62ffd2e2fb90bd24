#include "randomize/appearance/texture_source.h"

#include "randomize/appearance/pattern.h"

namespace synthetic_dataset::randomize {

TextureSource::TextureSource(const std::string& from) {
  if (from != "procedural") pictures_.emplace(from, PictureKind::kEncoded);
}

std::pair<std::string, std::shared_ptr<const world::Texture>> TextureSource::draw(
    base::RandomSource& random) {
  if (!pictures_) return drawPattern(random);
  const std::size_t index = random.index(pictures_->files().size());
  return {pictures_->files()[index], pictures_->read(index)};
}

}  // namespace synthetic_dataset::randomize
