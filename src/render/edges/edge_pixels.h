#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/geometry/geometry_images.h"
#include "synthetic_dataset/camera_model.h"

namespace synthetic_dataset::render {

/// Pixels whose centre sees a different surface than a neighbour's centre.
class EdgePixels {
 public:
  /// @param images  of the pixels of `place`
  /// @param regions  within `place`; contain all wanted pixels
  /// @param wanted  CV_8UC1, of the picture: 255 for the wanted pixels, else 0
  /// @param rays  CV_32FC3, of the picture: the pixels' rays, along which depths are measured;
  ///   empty for a pinhole camera
  EdgePixels(const GeometryImages& images, const cv::Rect& place,
             const std::vector<cv::Rect>& regions, const cv::Mat& wanted,
             const Intrinsics& intrinsics, const cv::Mat& rays = {});

  [[nodiscard]] const std::vector<cv::Point>& pixels() const { return pixels_; }

  /// A mask of a picture of this size: CV_8UC1, 255 for the edge pixels, else 0.
  [[nodiscard]] cv::Mat mask(const cv::Size& size) const;

  /// Calls visit(index in pixels()) for the edge pixels in a rectangle.
  template <class Visit>
  void visit(const cv::Rect& rectangle, const Visit& visit) const {
    const cv::Rect inside = rectangle & place_;
    if (inside.empty()) return;
    const int left = inside.x - place_.x;
    const int right = left + inside.width;
    for (int v = inside.y - place_.y; v < inside.y - place_.y + inside.height; ++v) {
      for (int word = left / kWordBits; word * kWordBits < right; ++word) {
        const Word& here = words_[static_cast<std::size_t>(v * row_words_ + word)];
        const int first = std::max(left - word * kWordBits, 0);
        const int end = std::min(right - word * kWordBits, kWordBits);
        std::uint64_t bits = here.bits >> first << first;
        bits = bits << (kWordBits - end) >> (kWordBits - end);
        if (bits == 0) continue;
        const std::uint64_t before = here.bits & ((std::uint64_t{1} << first) - 1);
        for (auto i = here.first + static_cast<std::size_t>(__builtin_popcountll(before));
             bits != 0; bits &= bits - 1) {
          visit(i++);
        }
      }
    }
  }

 private:
  static constexpr int kWordBits = 64;

  /// Which of 64 adjacent pixels of a row are at an edge: the leftmost in the lowest bit.
  struct Word {
    std::uint64_t bits = 0;
    std::size_t first = 0;  ///< index in pixels_ of the first of them
  };

  void addWord(const std::uint8_t* is_edge, const cv::Point& first);

  cv::Rect place_;
  std::vector<cv::Point> pixels_;  ///< row by row
  int row_words_;
  std::vector<Word> words_;  ///< of `place`, row by row
};

}  // namespace synthetic_dataset::render
