#include "synthetic_dataset/mask.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include <opencv2/core.hpp>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset {
inline namespace v2 {
namespace {

constexpr int kWord = 8;  // pixels that are tested at once

bool isEmpty(const std::uint8_t* pixels) {
  std::uint64_t word = 0;
  static_assert(sizeof word == kWord);
  std::memcpy(&word, pixels, sizeof word);
  return word == 0;
}

/// The first non-zero pixel of a row; `end` if there is none before it.
int firstOf(const std::uint8_t* row, int end) {
  int at = 0;
  while (at + kWord <= end && isEmpty(row + at)) at += kWord;
  while (at < end && row[at] == 0) ++at;
  return at;
}

/// One past the last non-zero pixel of a row; `begin` if there is none from there on.
int endOf(const std::uint8_t* row, int begin, int end) {
  while (end - kWord >= begin && isEmpty(row + end - kWord)) end -= kWord;
  while (end > begin && row[end - 1] == 0) --end;
  return end;
}

}  // namespace

cv::Rect maskBounds(const cv::Mat& mask) {
  CV_Assert(mask.empty() || mask.type() == CV_8UC1);
  int left = mask.cols;
  int right = 0;
  int top = mask.rows;
  int bottom = 0;
  for (int row = 0; row < mask.rows; ++row) {
    const auto* pixels = mask.ptr<std::uint8_t>(row);
    const int first = firstOf(pixels, mask.cols);
    if (first == mask.cols) continue;
    left = std::min(left, first);
    right = endOf(pixels, std::max(right, first + 1), mask.cols);
    top = std::min(top, row);
    bottom = row + 1;
  }
  if (bottom == 0) return {};
  return {left, top, right - left, bottom - top};
}

Mask::Mask(const cv::Mat& part, const cv::Point& offset, const cv::Size& image_size)
    : image_size_(image_size) {
  if (!part.empty() && part.type() != CV_8UC1) throw Error("a mask's pixels should be CV_8UC1");
  const cv::Rect extent = maskBounds(part);
  if (extent.empty()) return;
  const cv::Rect bounds = extent + offset;
  if ((bounds & cv::Rect({}, image_size)) != bounds) {
    throw Error("a mask has pixels outside of its image");
  }
  offset_ = bounds.tl();
  const bool shares = 2 * static_cast<std::size_t>(extent.area()) >= part.total();
  pixels_ = shares ? part(extent) : part(extent).clone();
}

std::int64_t Mask::count() const { return empty() ? 0 : cv::countNonZero(pixels_); }

bool Mask::at(const cv::Point& pixel) const {
  return bounds().contains(pixel) && pixels_.at<std::uint8_t>(pixel - offset_) != 0;
}

cv::Mat Mask::whole() const {
  cv::Mat image = cv::Mat::zeros(image_size_, CV_8UC1);
  if (!empty()) pixels_.copyTo(image(bounds()));
  return image;
}

}  // namespace v2
}  // namespace synthetic_dataset
