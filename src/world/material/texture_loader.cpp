#include "world/material/texture_loader.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "base/image/picture_channels.h"
#include "base/image/picture_decoder.h"
#include "base/input_file.h"
#include "synthetic_dataset/errors.h"
#include "world/files/text.h"
#include "world/material/gazebo_pictures.h"

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

/// The key of a picture without a file; no path begins like this.
std::string embeddedKey(const EmbeddedPicture& picture) {
  return "embedded " + std::to_string(reinterpret_cast<std::uintptr_t>(&picture));
}

cv::Mat contentOf(const cv::Mat& pixels, PictureContent content) {
  switch (content) {
    case PictureContent::kRed:
      return base::redAsGrey(pixels);
    case PictureContent::kInvertedRed:
      return base::invertedRedAsGrey(pixels);
    case PictureContent::kNormalsOrHeights:
      return base::isGrey(pixels) ? base::normalsOfHeights(pixels) : pixels;
    case PictureContent::kAlphaFromGrey:
      return base::greyAsAlpha(pixels);
    case PictureContent::kColour:
      break;
  }
  return pixels;
}

/// Multiplies pictures byte by byte, as OGRE's `modulate` does.
cv::Mat productOf(const cv::Mat& a, const cv::Mat& b) {
  const cv::Size size(std::max(a.cols, b.cols), std::max(a.rows, b.rows));
  cv::Mat first;
  cv::Mat second;
  cv::resize(a, first, size, 0.0, 0.0, cv::INTER_LINEAR);
  cv::resize(b, second, size, 0.0, 0.0, cv::INTER_LINEAR);
  cv::Mat product;
  cv::multiply(first, second, product, 1.0 / 255.0);
  return product;
}

constexpr const char* kGazeboTextures = "media/materials/textures/";

/// The normal map of a flat surface: without it, nothing looks different.
constexpr const char* kFlatNormals = "flat_normal.png";

/// The name of the picture of Gazebo's own to which a URI refers; nothing for other URIs.
std::optional<std::string> gazeboPicture(const std::string& uri) {
  const std::size_t at = uri.rfind(kGazeboTextures);
  if (at == std::string::npos) return std::nullopt;
  return uri.substr(at + std::string_view(kGazeboTextures).size());
}

}  // namespace

std::optional<fs::path> TextureLoader::lookUp(const TextureReference& reference) const {
  const std::string uri = withSlashes(reference.uri);
  if (finder_.leadsOut(uri, reference.folder)) return finder_.find(uri, reference.folder);
  const fs::path name = fs::path(uri).filename();
  const auto fileAt = [&](const std::optional<fs::path>& path) {
    std::error_code ignored;
    return path && !fs::is_directory(*path, ignored) ? path : std::nullopt;
  };
  if (auto file = fileAt(finder_.find(uri, reference.folder))) return file;
  std::vector<fs::path> paths = {reference.folder / name,
                                 reference.folder / "../materials/textures" / name};
  for (const fs::path& folder : reference.more_folders) {
    paths.push_back(folder / fs::path(uri).relative_path());
    paths.push_back(folder / name);
  }
  for (const fs::path& path : paths) {
    if (auto file = fileAt(finder_.at(path.lexically_normal()))) return file;
  }
  return fileAt(finder_.find(kGazeboTextures + name.string(), reference.folder));
}

fs::path TextureLoader::find(const TextureReference& reference) const {
  if (const auto file = lookUp(reference)) return *file;
  const std::string uri = withSlashes(reference.uri);
  const std::string reason = "texture '" + reference.uri + "': no such file; " +
                             finder_.searchedPlaces(uri, reference.folder);
  if (finder_.leadsOut(uri, reference.folder)) throw Error(reason);
  std::string more;
  for (const fs::path& folder : reference.more_folders) {
    more += ", " + folder.lexically_normal().string();
  }
  throw Error(reason + ", and for '" + fs::path(uri).filename().string() + "' in " +
              reference.folder.string() + ", " +
              (reference.folder / "../materials/textures").lexically_normal().string() + more);
}

const cv::Mat& TextureLoader::pixels(const std::string& key,
                                     const std::function<std::vector<std::uint8_t>()>& read) {
  auto found = pixels_.find(key);
  if (found == pixels_.end()) {
    std::variant<cv::Mat, std::string> result;
    try {
      result = base::decodePicture(read(), key);
    } catch (const Error& error) {
      result = std::string(error.what());
    }
    found = pixels_.emplace(key, std::move(result)).first;
  }
  if (const auto* reason = std::get_if<std::string>(&found->second)) throw Error(*reason);
  return std::get<cv::Mat>(found->second);
}

void TextureLoader::decodeAhead(const std::vector<TextureReference>& references) {
  std::map<std::string, std::vector<std::uint8_t>> files;
  for (const TextureReference& reference : references) {
    if (const EmbeddedPicture* embedded = reference.embedded.get()) {
      embedded_.push_back(reference.embedded);
      const std::string key = embeddedKey(*embedded);
      if (pixels_.count(key) == 0) files.emplace(key, embedded->bytes);
      continue;
    }
    try {
      const std::string file = find(reference).string();
      const bool is_known = files.count(file) > 0 || pixels_.count(file) > 0;
      if (!is_known) files.emplace(file, base::readInputBytes(file));
    } catch (const Error&) {
      continue;  // reported when it is loaded
    }
  }
  for (auto& [key, pixels] : base::decodePictures(files)) pixels_.emplace(key, std::move(pixels));
}

std::shared_ptr<const Texture> TextureLoader::standIn(const std::string& picture) {
  if (picture == kFlatNormals) return nullptr;
  stand_ins_.insert(picture);
  return made("Gazebo/" + picture, [&] { return paintGazeboPicture(picture); });
}

std::shared_ptr<const Texture> TextureLoader::load(const TextureReference& reference) {
  const EmbeddedPicture* embedded = reference.embedded.get();
  const auto of_gazebo = gazeboPicture(withSlashes(reference.uri));
  if (embedded == nullptr && of_gazebo && isGazeboPicture(*of_gazebo) && !lookUp(reference)) {
    return standIn(*of_gazebo);
  }
  const std::string file = embedded != nullptr ? embedded->name : find(reference).string();
  const std::string key = embedded != nullptr ? embeddedKey(*embedded) : file;
  auto& texture = textures_[{key, reference.alpha, reference.content}];
  if (texture) return texture;
  if (embedded != nullptr) embedded_.push_back(reference.embedded);
  cv::Mat content;
  try {
    content = contentOf(
        pixels(key, [&] { return embedded ? embedded->bytes : base::readInputBytes(file); }),
        reference.content);
  } catch (const Error& error) {
    throw Error("texture '" + file + "': " + error.what());
  }
  if (reference.alpha == AlphaMeaning::kIgnored) content = base::withoutAlpha(content);
  texture = std::make_shared<Texture>(Texture{file, content});
  return texture;
}

std::shared_ptr<const Texture> TextureLoader::loadWithOpacity(const TextureReference& colour,
                                                              const TextureReference& opacity) {
  const std::shared_ptr<const Texture> base = load(colour);
  const std::shared_ptr<const Texture> alpha = load(opacity);
  if (!base || !alpha) return base ? base : alpha;
  auto& texture = with_opacity_[{base.get(), alpha.get()}];
  if (!texture) {
    texture = std::make_shared<Texture>(
        Texture{base->file, base::withAlphaOf(base->pixels, alpha->pixels)});
  }
  return texture;
}

std::shared_ptr<const Texture> TextureLoader::loadProduct(const TextureReference& colour,
                                                          const TextureReference& factor) {
  const std::shared_ptr<const Texture> base = load(colour);
  const std::shared_ptr<const Texture> times = load(factor);
  if (!base || !times) return base ? base : times;
  auto& texture = products_[{base.get(), times.get()}];
  if (!texture) {
    texture =
        std::make_shared<Texture>(Texture{base->file, productOf(base->pixels, times->pixels)});
  }
  return texture;
}

std::shared_ptr<const Texture> TextureLoader::made(const std::string& name,
                                                   const std::function<cv::Mat()>& make) {
  auto& texture = textures_[{name, AlphaMeaning::kOpacity, PictureContent::kColour}];
  if (!texture) texture = std::make_shared<Texture>(Texture{name, make()});
  return texture;
}

}  // namespace synthetic_dataset::world
