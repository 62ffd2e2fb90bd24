#include "output/scene_contents.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "base/image/deflate.h"
#include "base/image/png_encoder.h"
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
    sum = base::crc32(sum, bytes, size);
  });
  return sum;
}

/// Whether both are the very same image in memory, as when several writers were given it.
bool areSame(const cv::Mat& a, const cv::Mat& b) {
  return a.data == b.data && a.size() == b.size() && a.type() == b.type() && a.step[0] == b.step[0];
}

bool areSame(const Mask& a, const Mask& b) {
  return a.imageSize() == b.imageSize() && a.bounds() == b.bounds() &&
         areSame(a.pixels(), b.pixels());
}

bool isMask(const OutputFile& file) { return !file.mask.imageSize().empty(); }

bool haveSamePixels(const cv::Mat& a, const cv::Mat& b) {
  bool same = true;
  visitRows(a, [&](const uchar* bytes, std::size_t size, int row) {
    same = same && std::memcmp(bytes, b.ptr(row), size) == 0;
  });
  return same;
}

/// Images seen before: all writers of a scene are given the same images, so the same one may come
/// several times.
class GivenImages {
 public:
  void add(const OutputFile& file, base::ImageFormat format, std::size_t content) {
    given_.push_back({&file, format, content});
  }

  /// The content index of the same image.
  [[nodiscard]] std::optional<std::size_t> find(const OutputFile& file,
                                                base::ImageFormat format) const {
    const auto found = std::find_if(given_.begin(), given_.end(), [&](const Given& other) {
      return other.format == format && areSame(other.file->pixels, file.pixels) &&
             areSame(other.file->mask, file.mask) && other.file->palette == file.palette;
    });
    if (found == given_.end()) return std::nullopt;
    return found->content;
  }

 private:
  struct Given {
    const OutputFile* file;
    base::ImageFormat format;
    std::size_t content;
  };
  std::vector<Given> given_;
};

/// Finds images of equal pixels, without encoding them.
class EqualImages {
 public:
  /// The content index of an equal image. If there is none, registers the image under `content`.
  std::optional<std::size_t> find(const OutputFile& file, base::ImageFormat format,
                                  std::size_t content) {
    const cv::Mat& pixels = file.pixels;
    std::vector<uchar> colours;
    for (const cv::Vec3b& colour : file.palette) {
      colours.insert(colours.end(), {colour[0], colour[1], colour[2]});
    }
    auto& alike = images_[std::make_tuple(pixels.rows, pixels.cols, pixels.type(), format,
                                          std::move(colours))];
    alike.push_back({pixels, content, std::nullopt});
    if (alike.size() == 1) return std::nullopt;  // the first of its kind
    const std::uint32_t sum = alike.back().sum();
    const auto equal = std::find_if(alike.begin(), alike.end(), [&](Image& image) {
      return image.sum() == sum && haveSamePixels(image.pixels, pixels);
    });
    if (&*equal == &alike.back()) return std::nullopt;
    alike.pop_back();
    return equal->content;
  }

 private:
  struct Image {
    cv::Mat pixels;
    std::size_t content;
    std::optional<std::uint32_t> checksum;  ///< set on first use

    [[nodiscard]] std::uint32_t sum() {
      if (!checksum) checksum = checksumOf(pixels);
      return *checksum;
    }
  };
  using Key = std::tuple<int, int, int, base::ImageFormat, std::vector<uchar>>;

  std::map<Key, std::vector<Image>> images_;
};

SceneContent encoded(const OutputFile& file, const base::ImageQuality& quality) {
  try {
    if (!file.palette.empty()) {
      return {base::encodePng(file.pixels, file.palette, quality.png_compression), {}, {}};
    }
    if (const auto problem = base::imageProblem(file.path, file.pixels)) throw Error(*problem);
    return {base::encodeImage(file.pixels, *base::imageFormat(file.path), quality), {}, {}};
  } catch (const Error& error) {
    throw Error("cannot write '" + file.path + "': " + error.what());
  }
}

/// Collects the contents of files.
class SceneEncoder {
 public:
  SceneEncoder(const base::ImageQuality& quality, const RecordedJpeg& recorded)
      : quality_(quality), recorded_(recorded) {}

  void addText(const OutputFile& file, std::size_t index) {
    contents_.push_back({{}, file.text, {index}});
  }

  void addImage(const OutputFile& file, std::size_t index) {
    const std::optional<base::ImageFormat> format = base::imageFormat(file.path);
    if (!format) {
      throw Error("cannot write '" + file.path +
                  "': " + *base::imageProblem(file.path, file.pixels));
    }
    std::optional<std::size_t> content = given_.find(file, *format);
    if (!content) {
      content = isMask(file) ? addPixels(wholeMask(file), *format) : addPixels(file, *format);
      given_.add(file, *format, *content);
    }
    contents_[*content].files.push_back(index);
  }

  [[nodiscard]] std::vector<SceneContent> take() { return std::move(contents_); }

 private:
  /// Whether an image is encoded quickly, as masks are: comparing their pixels with those of others
  /// takes longer than compressing them.
  [[nodiscard]] static bool isSoonEncoded(const OutputFile& file, base::ImageFormat format) {
    return file.pixels.type() == CV_8UC1 && format == base::ImageFormat::kPng &&
           file.palette.empty();
  }

  /// The whole mask as pixels, which are kept only while they are encoded.
  [[nodiscard]] static OutputFile wholeMask(const OutputFile& file) {
    OutputFile whole;
    whole.path = file.path;
    whole.pixels = file.mask.whole();
    return whole;
  }

  std::size_t addPixels(const OutputFile& file, base::ImageFormat format) {
    return isSoonEncoded(file, format) ? addMask(file) : addPicture(file, format);
  }

  std::size_t addMask(const OutputFile& file) {
    SceneContent made = encoded(file, quality_);
    const auto equal = std::find_if(masks_.begin(), masks_.end(), [&](std::size_t mask) {
      return contents_[mask].encoded == made.encoded;
    });
    if (equal != masks_.end()) return *equal;
    masks_.push_back(contents_.size());
    contents_.push_back(std::move(made));
    return masks_.back();
  }

  std::size_t addPicture(const OutputFile& file, base::ImageFormat format) {
    const std::size_t next = contents_.size();
    if (const auto equal = equal_.find(file, format, next)) return *equal;
    const bool is_recorded = !recorded_.bytes.empty() && format == base::ImageFormat::kJpeg &&
                             areSame(file.pixels, recorded_.pixels);
    contents_.push_back(is_recorded ? SceneContent{recorded_.bytes, {}, {}}
                                    : encoded(file, quality_));
    return next;
  }

  base::ImageQuality quality_;
  const RecordedJpeg& recorded_;
  GivenImages given_;
  EqualImages equal_;
  std::vector<SceneContent> contents_;
  std::vector<std::size_t> masks_;  ///< the contents that are masks
};

}  // namespace

std::string_view SceneContent::bytes() const {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are bytes
  return encoded.empty()
             ? text
             : std::string_view(reinterpret_cast<const char*>(encoded.data()), encoded.size());
}

std::vector<SceneContent> encodeScene(const std::vector<OutputFile>& files,
                                      const base::ImageQuality& quality,
                                      const RecordedJpeg& recorded) {
  SceneEncoder encoder(quality, recorded);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i].pixels.empty() && !isMask(files[i])) {
      encoder.addText(files[i], i);
    } else {
      encoder.addImage(files[i], i);
    }
  }
  return encoder.take();
}

}  // namespace synthetic_dataset::output
