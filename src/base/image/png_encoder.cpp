#include "base/image/png_encoder.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>

#include <opencv2/core.hpp>
#include <opencv2/core/hal/intrin.hpp>
#include <opencv2/imgproc.hpp>

#include "base/image/deflate.h"
#include "base/image/image_encoder.h"
#include "base/image/run_deflater.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

using Bytes = std::vector<uchar>;

constexpr std::size_t kMostColours = 256;

enum ColourType : uchar { kGrey = 0, kTrueColour = 2, kIndexed = 3 };
enum FilterType : uchar { kNone = 0, kSub = 1, kUp = 2 };

void appendNumber(Bytes& bytes, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<uchar>(number >> shift));
}

void appendChunk(Bytes& png, const char* type, const uchar* data, std::size_t size) {
  appendNumber(png, static_cast<std::uint32_t>(size));
  const std::size_t checked = png.size();
  png.insert(png.end(), type, type + 4);
  png.insert(png.end(), data, data + size);
  appendNumber(png, crc32(0, png.data() + checked, png.size() - checked));
}

/// A row's samples in PNG's order: red first, high byte first.
void takeRow(const cv::Mat& image, int row, uchar* to) {
  if (image.type() == CV_8UC3) {
    cv::Mat red_first(1, image.cols, CV_8UC3, to);
    cv::cvtColor(image.row(row), red_first, cv::COLOR_BGR2RGB);
  } else if (image.type() == CV_16UC1) {
    const auto* from = image.ptr<std::uint16_t>(row);
    for (int u = 0; u < image.cols; ++u) {
      to[2 * u] = static_cast<uchar>(from[u] >> 8U);
      to[2 * u + 1] = static_cast<uchar>(from[u]);
    }
  } else {
    std::copy_n(image.ptr<uchar>(row), image.cols, to);
  }
}

/// Filters rows one after another, each with the filter that leaves the smallest sum of absolute
/// differences, the criterion of PNG's authors (ISO/IEC 15948, 12.8).
class RowFilter {
 public:
  RowFilter(std::size_t row_bytes, std::size_t pixel_bytes)
      : size_(row_bytes),
        pixel_(pixel_bytes),
        row_(pixel_bytes + row_bytes, 0),
        above_(pixel_bytes + row_bytes, 0) {}

  /// The row to filter.
  [[nodiscard]] uchar* row() { return row_.data() + pixel_; }

  /// Writes the filter's type and the filtered bytes, and advances to the next row.
  void filter(uchar* to) {
    // The pixel to the left of the first one is 0.
    const uchar* const left = row_.data();
    const uchar* const up = above_.data() + pixel_;
    const Sums sums = sumsOf(row(), left, up);
    const std::uint32_t least = std::min({sums.none, sums.sub, sums.up});
    const FilterType type = least == sums.none ? kNone : least == sums.sub ? kSub : kUp;
    *to++ = type;
    if (type == kNone) {
      std::copy_n(row(), size_, to);
    } else {
      std::transform(row(), row() + size_, type == kSub ? left : up, to, std::minus<uchar>());
    }
    row_.swap(above_);
    std::fill_n(row_.begin(), pixel_, uchar{0});
  }

 private:
  struct Sums {
    std::uint32_t none = 0, sub = 0, up = 0;
  };

  [[nodiscard]] Sums sumsOf(const uchar* bytes, const uchar* left, const uchar* up) const {
    constexpr std::size_t kAtOnce = 16;
    const cv::v_uint8x16 zero = cv::v_setzero_u8();
    const auto amount = [&](const cv::v_uint8x16& difference) {
      return cv::v_reduce_sad(cv::v_min(difference, cv::v_sub_wrap(zero, difference)), zero);
    };
    Sums sums;
    std::size_t i = 0;
    for (; i + kAtOnce <= size_; i += kAtOnce) {
      const cv::v_uint8x16 here = cv::v_load(bytes + i);
      sums.none += amount(here);
      sums.sub += amount(cv::v_sub_wrap(here, cv::v_load(left + i)));
      sums.up += amount(cv::v_sub_wrap(here, cv::v_load(up + i)));
    }
    const auto amountOf = [](int difference) {
      return std::uint32_t{
          std::min(static_cast<uchar>(difference), static_cast<uchar>(-difference))};
    };
    for (; i < size_; ++i) {
      sums.none += amountOf(bytes[i]);
      sums.sub += amountOf(bytes[i] - left[i]);
      sums.up += amountOf(bytes[i] - up[i]);
    }
    return sums;
  }

  std::size_t size_;
  std::size_t pixel_;
  Bytes row_;    ///< after a pixel of zeros
  Bytes above_;  ///< the same
};

/// CV_8UC1: a filtered row for each of the image's, preceded by its filter's type.
cv::Mat filteredRows(const cv::Mat& image) {
  const std::size_t pixel_bytes = image.elemSize();
  const std::size_t row_bytes = pixel_bytes * static_cast<std::size_t>(image.cols);
  cv::Mat rows(image.rows, static_cast<int>(row_bytes + 1), CV_8UC1);
  RowFilter filter(row_bytes, pixel_bytes);
  for (int row = 0; row < image.rows; ++row) {
    takeRow(image, row, filter.row());
    filter.filter(rows.ptr(row));
  }
  return rows;
}

/// Where a run of equal bytes ends.
const uchar* endOfRun(const uchar* begin, const uchar* end) {
  std::uint64_t eight = 0;
  std::memset(&eight, *begin, sizeof(eight));
  const uchar* at = begin;
  for (std::uint64_t these = eight; end - at >= 8; at += 8) {
    std::memcpy(&these, at, sizeof(these));
    if (these != eight) break;
  }
  while (at != end && *at == *begin) ++at;
  return at;
}

/// Whether a row's bytes are all equal, as those of most rows of a mask are.
bool isOneRun(const uchar* row, int size) {
  return std::memcmp(row, row + 1, static_cast<std::size_t>(size) - 1) == 0;
}

/// A mask's rows, unfiltered; nullopt if a pixel is neither black nor white.
std::optional<Bytes> deflatedMask(const cv::Mat& image) {
  if (image.type() != CV_8UC1) return std::nullopt;
  RunDeflater deflater;
  for (int row = 0; row < image.rows; ++row) {
    deflater.add(kNone, 1);
    const uchar* at = image.ptr<uchar>(row);
    const uchar* const row_end = at + image.cols;
    const bool one_run = isOneRun(at, image.cols);
    while (at != row_end) {
      if (*at != 0 && *at != 255) return std::nullopt;
      const uchar* const run_end = one_run ? row_end : endOfRun(at, row_end);
      deflater.add(*at, static_cast<std::size_t>(run_end - at));
      at = run_end;
    }
  }
  return deflater.finish();
}

Bytes header(const cv::Mat& image, bool indexed) {
  Bytes bytes;
  appendNumber(bytes, static_cast<std::uint32_t>(image.cols));
  appendNumber(bytes, static_cast<std::uint32_t>(image.rows));
  bytes.push_back(image.depth() == CV_16U ? 16 : 8);
  bytes.push_back(indexed ? kIndexed : image.channels() == 3 ? kTrueColour : kGrey);
  bytes.insert(bytes.end(), 3, 0);  // deflate; the standard filters; not interlaced
  return bytes;
}

}  // namespace

std::optional<std::string> indexedImageProblem(const std::string& path, const cv::Mat& indices,
                                               const std::vector<cv::Vec3b>& palette) {
  if (imageFormat(path) != ImageFormat::kPng) return "its name should end in .png";
  if (indices.empty() || indices.dims != 2) return "the image has no pixels";
  if (indices.type() != CV_8UC1) {
    return "the pixels are " + cv::typeToString(indices.type()) + "; they should be CV_8UC1";
  }
  if (palette.empty() || palette.size() > kMostColours) {
    return "it has " + std::to_string(palette.size()) + " colours; it should have 1 to 256";
  }
  double greatest = 0.0;
  cv::minMaxIdx(indices, nullptr, &greatest);
  if (greatest >= static_cast<double>(palette.size())) {
    return "a pixel is " + std::to_string(static_cast<int>(greatest)) + ", but there are only " +
           std::to_string(palette.size()) + " colours";
  }
  return std::nullopt;
}

Bytes encodePng(const cv::Mat& image, const std::vector<cv::Vec3b>& palette, int compression) {
  std::optional<Bytes> data = palette.empty() ? deflatedMask(image) : std::nullopt;
  if (!data) data = deflated(filteredRows(image), compression);
  const Bytes head = header(image, !palette.empty());
  Bytes png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  png.reserve(data->size() + 1024);
  appendChunk(png, "IHDR", head.data(), head.size());
  if (!palette.empty()) {
    Bytes colours;
    for (const cv::Vec3b& colour : palette) {
      colours.insert(colours.end(), {colour[2], colour[1], colour[0]});
    }
    appendChunk(png, "PLTE", colours.data(), colours.size());
  }
  appendChunk(png, "IDAT", data->data(), data->size());
  appendChunk(png, "IEND", nullptr, 0);
  return png;
}

}  // namespace synthetic_dataset::base
