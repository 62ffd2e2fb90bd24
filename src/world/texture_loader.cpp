#include "world/texture_loader.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "synthetic_dataset/errors.h"
#include "world/picture_file.h"

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

/// Colours of any depth and count of channels as blue, green, red, alpha of 8 bits.
cv::Mat toBgra(const cv::Mat& picture) {
  cv::Mat bytes;
  if (picture.depth() == CV_8U) {
    bytes = picture;
  } else if (picture.depth() == CV_16U) {
    picture.convertTo(bytes, CV_8U, 1.0 / 257.0);
  } else {
    return {};
  }
  cv::Mat bgra;
  switch (bytes.channels()) {
    case 1:
      cv::cvtColor(bytes, bgra, cv::COLOR_GRAY2BGRA);
      return bgra;
    case 3:
      cv::cvtColor(bytes, bgra, cv::COLOR_BGR2BGRA);
      return bgra;
    case 4:
      return bytes;
    default:
      return {};
  }
}

cv::Mat decode(const std::vector<std::uint8_t>& bytes) {
  const std::vector<std::uint8_t> essential = withoutColourProfile(bytes);
  if (essential.empty()) return {};
  try {
    return toBgra(cv::imdecode(essential, cv::IMREAD_UNCHANGED));
  } catch (const cv::Exception&) {
    return {};
  }
}

std::shared_ptr<const Texture> makeTexture(const std::string& name,
                                           const std::vector<std::uint8_t>& bytes,
                                           AlphaMeaning alpha) {
  cv::Mat pixels = decode(bytes);
  if (pixels.empty()) {
    throw Error("texture '" + name +
                "': cannot be decoded; PNG, JPEG, BMP, TIFF and WebP pictures can");
  }
  if (alpha == AlphaMeaning::kIgnored) {
    cv::Mat opaque(pixels.size(), CV_8UC1, cv::Scalar(255));
    cv::insertChannel(opaque, pixels, 3);
  }
  return std::make_shared<Texture>(Texture{name, pixels});
}

std::vector<std::uint8_t> readBytes(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace

fs::path TextureLoader::find(const TextureReference& reference) const {
  std::string uri = reference.uri;
  std::replace(uri.begin(), uri.end(), '\\', '/');  // Windows' exporters
  const std::string name = fs::path(uri).filename().string();
  for (const std::string& place : {uri, name, "../materials/textures/" + name}) {
    const std::optional<fs::path> file = finder_.find(place, reference.folder);
    std::error_code ignored;
    if (file && fs::is_regular_file(*file, ignored)) return *file;
  }
  throw Error("texture '" + reference.uri + "': no such file; " +
              finder_.searchedPlaces(uri, reference.folder) + ", and for '" + name + "' in " +
              reference.folder.string() + ", " +
              (reference.folder / "../materials/textures").lexically_normal().string());
}

std::shared_ptr<const Texture> TextureLoader::load(const TextureReference& reference) {
  if (reference.embedded) {
    auto& texture = embedded_[{reference.embedded.get(), reference.alpha}];
    if (!texture) {
      texture = makeTexture(reference.embedded->name, reference.embedded->bytes, reference.alpha);
    }
    return texture;
  }
  const fs::path file = find(reference);
  auto& texture = files_[{file.string(), reference.alpha}];
  if (!texture) texture = makeTexture(file.string(), readBytes(file), reference.alpha);
  return texture;
}

}  // namespace synthetic_dataset::world
