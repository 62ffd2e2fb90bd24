#include "output/scene_contents.h"

#include <map>
#include <tuple>
#include <utility>

#include "output/png_encoder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

/// What two images have in common that have the same pixels, colours and format.
auto keyOf(const OutputFile& file, ImageFormat format) {
  std::vector<uchar> colours;
  for (const cv::Vec3b& colour : file.palette) {
    colours.insert(colours.end(), {colour[0], colour[1], colour[2]});
  }
  const cv::Mat& pixels = file.pixels;
  return std::make_tuple(pixels.data, pixels.rows, pixels.cols, pixels.step[0], pixels.type(),
                         format, std::move(colours));
}

SceneContent encoded(const OutputFile& file, const ImageQuality& quality) {
  try {
    if (!file.palette.empty()) {
      return {encodePng(file.pixels, file.palette, quality.png_compression), {}, {}};
    }
    if (const auto problem = imageProblem(file.path, file.pixels)) throw Error(*problem);
    return {encodeImage(file.pixels, *imageFormat(file.path), quality), {}, {}};
  } catch (const Error& error) {
    throw Error("cannot write '" + file.path + "': " + error.what());
  }
}

}  // namespace

std::string_view SceneContent::bytes() const {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are bytes
  return encoded.empty()
             ? text
             : std::string_view(reinterpret_cast<const char*>(encoded.data()), encoded.size());
}

std::vector<SceneContent> encodeScene(const std::vector<OutputFile>& files,
                                      const ImageQuality& quality) {
  using Key = decltype(keyOf(OutputFile(), ImageFormat::kPng));
  std::map<Key, std::size_t> known;
  std::vector<SceneContent> contents;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const OutputFile& file = files[i];
    if (file.pixels.empty()) {
      contents.push_back({{}, file.text, {i}});
      continue;
    }
    const std::optional<ImageFormat> format = imageFormat(file.path);
    if (format) {
      const auto [place, is_new] = known.try_emplace(keyOf(file, *format), contents.size());
      if (!is_new) {
        contents[place->second].files.push_back(i);
        continue;
      }
    }
    contents.push_back(encoded(file, quality));
    contents.back().files.push_back(i);
  }
  return contents;
}

}  // namespace synthetic_dataset::output
