#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/geometry/geometry_buffer.h"
#include "synthetic_dataset/camera_model.h"

namespace synthetic_dataset::render {

/// The pixels of some regions whose centre sees another surface than a neighbour's.
class EdgePixels {
 public:
  /// @param images  of the pixels of `place`
  /// @param regions  those that are looked at, within `place`
  EdgePixels(const GeometryImages& images, const cv::Rect& place,
             const std::vector<cv::Rect>& regions, const Intrinsics& intrinsics);

  [[nodiscard]] const std::vector<cv::Point>& pixels() const { return pixels_; }

  /// CV_8UC1 of a picture of this size, 255 for these pixels, else 0.
  [[nodiscard]] cv::Mat mask(const cv::Size& size) const;

  /// Calls visit(index in pixels()) for those in a rectangle.
  template <class Visit>
  void visit(const cv::Rect& rectangle, const Visit& visit) const {
    const cv::Rect inside = rectangle & place_;
    for (int v = inside.y; v < inside.y + inside.height; ++v) {
      const int row = v - place_.y;
      const int end = rows_[static_cast<std::size_t>(row) + 1];
      if (rows_[static_cast<std::size_t>(row)] == end) continue;
      // From the block's first edge pixel on, some may still be before the rectangle.
      for (int i = blocks_.at<int>(row, (inside.x - place_.x) / kBlock); i < end; ++i) {
        if (pixels_[static_cast<std::size_t>(i)].x < inside.x) continue;
        if (pixels_[static_cast<std::size_t>(i)].x >= inside.x + inside.width) break;
        visit(static_cast<std::size_t>(i));
      }
    }
  }

 private:
  static constexpr int kBlock = 8;  ///< [px]

  void addBlock(const std::uint8_t* is_edge, const cv::Point& first);

  cv::Rect place_;
  std::vector<cv::Point> pixels_;  ///< row by row
  std::vector<int> rows_;          ///< where each row begins in pixels_, and the end
  cv::Mat blocks_;  ///< CV_32SC1: for each kBlock pixels of `place`, the first of pixels_ in this
                    ///< row from there on
};

}  // namespace synthetic_dataset::render
