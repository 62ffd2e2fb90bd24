#include "output/scene_contents.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <libdeflate.h>

#include "output/image/png_encoder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

/// Calls visit(bytes, size) for each row of pixels.
template <class Visit>
void visitRows(const cv::Mat& pixels, const Visit& visit) {
  const std::size_t size = pixels.elemSize() * static_cast<std::size_t>(pixels.cols);
  for (int row = 0; row < pixels.rows; ++row) visit(pixels.ptr(row), size, row);
}

std::uint32_t checksumOf(const cv::Mat& pixels) {
  std::uint32_t sum = 0;
  visitRows(pixels, [&](const uchar* bytes, std::size_t size, int /*row*/) {
    sum = libdeflate_crc32(sum, bytes, size);
  });
  return sum;
}

/// Whether these are not only alike, as images that several writers were given are.
bool areSame(const cv::Mat& a, const cv::Mat& b) {
  return a.data == b.data && a.size() == b.size() && a.type() == b.type() && a.step[0] == b.step[0];
}

bool haveSamePixels(const cv::Mat& a, const cv::Mat& b) {
  bool same = true;
  visitRows(a, [&](const uchar* bytes, std::size_t size, int row) {
    same = same && std::memcmp(bytes, b.ptr(row), size) == 0;
  });
  return same;
}

/// Finds images that become the same bytes.
class EqualImages {
 public:
  /// The content of an equal image, or null; then the image has this content.
  const std::size_t* find(const OutputFile& file, ImageFormat format, std::size_t content) {
    const cv::Mat& pixels = file.pixels;
    const auto given = std::find_if(given_.begin(), given_.end(), [&](const Given& other) {
      return other.format == format && areSame(other.file->pixels, pixels) &&
             other.file->palette == file.palette;
    });
    if (given != given_.end()) return &given->content;
    const std::size_t* equal = findEqual(file, format, content);
    given_.push_back({&file, format, equal != nullptr ? *equal : content});
    return equal;
  }

 private:
  /// One whose pixels are looked at.
  const std::size_t* findEqual(const OutputFile& file, ImageFormat format, std::size_t content) {
    const cv::Mat& pixels = file.pixels;
    std::vector<uchar> colours;
    for (const cv::Vec3b& colour : file.palette) {
      colours.insert(colours.end(), {colour[0], colour[1], colour[2]});
    }
    auto& alike = images_[std::make_tuple(pixels.rows, pixels.cols, pixels.type(), format,
                                          std::move(colours))];
    alike.push_back({pixels, content, std::nullopt});
    if (alike.size() == 1) return nullptr;  // of its kind
    const std::uint32_t sum = alike.back().sum();
    const auto equal = std::find_if(alike.begin(), alike.end(), [&](Image& image) {
      return image.sum() == sum && haveSamePixels(image.pixels, pixels);
    });
    if (&*equal == &alike.back()) return nullptr;
    alike.pop_back();
    return &equal->content;
  }

  struct Given {
    const OutputFile* file;
    ImageFormat format;
    std::size_t content;
  };
  struct Image {
    cv::Mat pixels;
    std::size_t content;
    std::optional<std::uint32_t> checksum;  ///< once it was asked for

    [[nodiscard]] std::uint32_t sum() {
      if (!checksum) checksum = checksumOf(pixels);
      return *checksum;
    }
  };
  using Key = std::tuple<int, int, int, ImageFormat, std::vector<uchar>>;

  std::vector<Given> given_;
  std::map<Key, std::vector<Image>> images_;
};

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
  EqualImages images;
  std::vector<SceneContent> contents;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const OutputFile& file = files[i];
    if (file.pixels.empty()) {
      contents.push_back({{}, file.text, {i}});
      continue;
    }
    const std::optional<ImageFormat> format = imageFormat(file.path);
    if (const auto* equal = format ? images.find(file, *format, contents.size()) : nullptr) {
      contents[*equal].files.push_back(i);
      continue;
    }
    contents.push_back(encoded(file, quality));
    contents.back().files.push_back(i);
  }
  return contents;
}

}  // namespace synthetic_dataset::output
