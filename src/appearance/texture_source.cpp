#include "appearance/texture_source.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <opencv2/core.hpp>

#include "appearance/pattern.h"
#include "synthetic_dataset/errors.h"
#include "world/material/picture_decoder.h"

namespace synthetic_dataset::appearance {
namespace {

namespace fs = std::filesystem;

bool isPicture(const fs::path& file) {
  static constexpr std::array<const char*, 7> kEndings = {".png", ".jpg",  ".jpeg", ".bmp",
                                                          ".tif", ".tiff", ".webp"};
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

}  // namespace

std::vector<std::string> picturesIn(const std::string& folder) {
  std::error_code problem;
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder, problem)) {
    if (entry.is_regular_file() && isPicture(entry.path())) files.push_back(entry.path().string());
  }
  if (problem) throw Error("found '" + folder + "': " + problem.message());
  if (files.empty()) {
    throw Error("found '" + folder + "', a folder without pictures (png, jpg, bmp, tif, webp)");
  }
  std::sort(files.begin(), files.end());
  return files;
}

TextureSource::TextureSource(const std::string& from) {
  if (from != "procedural") files_ = picturesIn(from);
}

std::pair<std::string, std::shared_ptr<const world::Texture>> TextureSource::draw(
    random::RandomSource& random) {
  if (files_.empty()) return drawPattern(random);
  const std::string& file = files_[random.index(files_.size())];
  return {file, read(file)};
}

std::shared_ptr<const world::Texture> TextureSource::read(const std::string& file) {
  constexpr std::size_t kMostKept = 32;
  auto found = std::find_if(recent_.begin(), recent_.end(),
                            [&](const auto& texture) { return texture->file == file; });
  if (found == recent_.end()) {
    std::ifstream stream(file, std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(stream), {}};
    world::Texture texture{file, {}};
    try {
      texture.pixels = world::decodePicture(bytes, file);
    } catch (const Error& error) {
      throw Error("texture '" + file + "': " + error.what());
    }
    cv::bitwise_or(texture.pixels, cv::Scalar(0, 0, 0, 255), texture.pixels);  // without holes
    if (recent_.size() == kMostKept) recent_.pop_back();
    found = recent_.insert(recent_.begin(), std::make_shared<world::Texture>(std::move(texture)));
  }
  std::rotate(recent_.begin(), found, found + 1);
  return recent_.front();
}

}  // namespace synthetic_dataset::appearance
