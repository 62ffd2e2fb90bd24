#include "render/parts/texture_library.h"

#include <iterator>

#include "base/image/picture_channels.h"
#include "render/gl/picture_upload.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::render {
namespace {

UploadedTexture upload(const GlFunctions& gl, const world::Texture& texture, PixelMeaning meaning) {
  const cv::Mat& pixels = texture.pixels;
  if (pixels.empty() || pixels.type() != CV_8UC4) {
    throw Error(texture.file + ": a texture should have pixels of four channels");
  }
  return {uploadPicture(gl, pixels, meaning, Mipmaps::kAll), base::isOpaque(pixels)};
}

}  // namespace

const UploadedTexture& TextureLibrary::get(const std::shared_ptr<const world::Texture>& texture,
                                           PixelMeaning meaning) {
  const auto key = std::make_pair(texture, meaning);
  auto entry = textures_.find(key);
  if (entry == textures_.end()) {
    entry = textures_.emplace(key, upload(gl_, *texture, meaning)).first;
  }
  return entry->second;
}

void TextureLibrary::forgetUnused() {
  std::map<const world::Texture*, long> held_here;  // twice if used as both colours and data
  for (const auto& [key, uploaded] : textures_) ++held_here[key.first.get()];
  for (auto entry = textures_.begin(); entry != textures_.end();) {
    const auto& texture = entry->first.first;
    const bool is_used = texture.use_count() > held_here.at(texture.get());
    entry = is_used ? std::next(entry) : textures_.erase(entry);
  }
}

}  // namespace synthetic_dataset::render
