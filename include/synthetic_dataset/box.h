#pragma once

#include <algorithm>
#include <optional>

#include <opencv2/core/types.hpp>

namespace synthetic_dataset {
inline namespace v2 {

/// An axis-aligned box in the image [px], in OpenCV's convention: the centre of the top left pixel
/// is (0, 0), so an image of W x H pixels spans (-0.5, -0.5) to (W - 0.5, H - 0.5).
struct Box {
  double left = 0.0;
  double top = 0.0;
  double right = 0.0;
  double bottom = 0.0;

  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return bottom - top; }
};

/// The box along the outer edges of a rectangle of pixels.
[[nodiscard]] inline Box boxAround(const cv::Rect& pixels) {
  return {pixels.x - 0.5, pixels.y - 0.5, pixels.br().x - 0.5, pixels.br().y - 0.5};
}

/// The part that both boxes cover; nullopt if they share no area.
[[nodiscard]] inline std::optional<Box> intersection(const Box& a, const Box& b) {
  const Box both{std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
                 std::min(a.bottom, b.bottom)};
  if (both.left < both.right && both.top < both.bottom) return both;
  return std::nullopt;
}

}  // namespace v2
}  // namespace synthetic_dataset
