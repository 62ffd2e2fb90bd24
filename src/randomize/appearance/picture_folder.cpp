#include "randomize/appearance/picture_folder.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include <opencv2/core.hpp>

#include "base/image/picture_decoder.h"
#include "base/input_file.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::randomize {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

bool isPicture(const fs::path& file, PictureKind kind) {
  static const std::set<std::string> kEncoded{".png", ".jpg",  ".jpeg", ".bmp",
                                              ".tif", ".tiff", ".webp"};
  static const std::set<std::string> kLight{".hdr", ".exr"};
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return kEncoded.count(ending) > 0 || (kind == PictureKind::kAny && kLight.count(ending) > 0);
}

/// Runs work on a picture's file; errors name the file.
template <class Work>
auto withFile(const std::string& file, const Work& work) {
  const Bytes bytes = base::readInputBytes(file);
  try {
    return work(bytes);
  } catch (const Error& error) {
    throw Error("picture '" + file + "' " + error.what());
  }
}

/// Keeps only the first few problems: a folder may have ten thousand broken pictures.
std::vector<std::string> shortened(std::vector<std::string> problems) {
  constexpr std::size_t kTold = 4;
  if (problems.size() <= kTold) return problems;
  const std::size_t others = problems.size() - kTold;
  problems.resize(kTold);
  problems.push_back("found " + std::to_string(others) + " more that cannot be decoded");
  return problems;
}

}  // namespace

std::vector<std::string> picturesIn(const std::string& folder, PictureKind kind) {
  std::error_code problem;
  std::vector<std::string> files;
  for (fs::recursive_directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    std::error_code unknown;
    if (isPicture(entry->path(), kind) && entry->is_regular_file(unknown)) {
      files.push_back(entry->path().string());
    }
  }
  if (problem) throw Error("found '" + folder + "': " + problem.message());
  if (files.empty()) {
    throw Error("found '" + folder + "', a folder without pictures (png, jpg, bmp, tif, webp" +
                (kind == PictureKind::kAny ? ", hdr, exr)" : ")"));
  }
  std::sort(files.begin(), files.end());
  return files;
}

PictureFolder::PictureFolder(const std::string& folder, PictureKind kind)
    : files_(picturesIn(folder, kind)) {
  std::vector<std::string> problems;
  for (const std::string& file : files_) {
    try {
      sizes_.push_back(
          withFile(file, [&](const Bytes& bytes) { return base::checkPicture(bytes, file); }));
    } catch (const Error& error) {
      problems.emplace_back(error.what());
    }
  }
  if (!problems.empty()) throw ErrorList(shortened(std::move(problems)));
}

std::shared_ptr<const world::Texture> PictureFolder::read(std::size_t index) {
  const std::string& file = files_.at(index);
  return recent_.get(index, [&] {
    world::Texture texture{file, withFile(file, [&](const Bytes& bytes) {
                             return base::decodePictureOrLight(bytes, file);
                           })};
    if (texture.pixels.depth() == CV_8U) {
      cv::bitwise_or(texture.pixels, cv::Scalar(0, 0, 0, 255), texture.pixels);  // without holes
    }
    return texture;
  });
}

}  // namespace synthetic_dataset::randomize
