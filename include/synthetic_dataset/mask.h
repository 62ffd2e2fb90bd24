#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset {
inline namespace v2 {

/// The bounding rectangle [px] of all non-zero pixels of a mask; empty if there are none.
///
/// cv::boundingRect of OpenCV 4.6 returns too small a rectangle for narrow shapes whose rows do not
/// begin at multiples of four bytes, as in parts of an image or images of odd width.
/// @param mask  CV_8UC1, of any size, even empty; may be a part of another image
[[nodiscard]] cv::Rect maskBounds(const cv::Mat& mask);

/// The pixels of an image that belong to an object, stored as the smallest part of the image that
/// contains them all: memory grows with the object's size in the image, not with the image. A value
/// type whose copies share their pixels, as those of cv::Mat do; the pixels are never changed.
class Mask {
 public:
  /// A mask without an image.
  Mask() = default;

  /// An empty mask of an image.
  explicit Mask(const cv::Size& image_size) : image_size_(image_size) {}

  /// @param part  CV_8UC1, 255 on the object and 0 elsewhere; empty margins are cropped, and the
  ///     rest is shared if it is at least half of the part, else copied
  /// @param offset  the image pixel at the part's top left pixel
  /// @throws Error if the part has another type, or a pixel of the object outside the image
  Mask(const cv::Mat& part, const cv::Point& offset, const cv::Size& image_size);

  /// A mask given as the whole image.
  explicit Mask(const cv::Mat& image) : Mask(image, {}, image.size()) {}

  /// Whether no pixel belongs to the object.
  [[nodiscard]] bool empty() const { return pixels_.empty(); }

  /// The tight bounding rectangle of its pixels [px]; empty if there are none.
  [[nodiscard]] cv::Rect bounds() const { return {offset_, pixels_.size()}; }

  /// The part of the image within `bounds()`: CV_8UC1, 255 on the object and 0 elsewhere.
  [[nodiscard]] const cv::Mat& pixels() const { return pixels_; }

  /// The image pixel at the top left pixel of `pixels()`.
  [[nodiscard]] cv::Point offset() const { return offset_; }

  [[nodiscard]] cv::Size imageSize() const { return image_size_; }

  /// The number of pixels that belong to the object.
  [[nodiscard]] std::int64_t count() const;

  /// Whether a pixel of the image belongs to the object; false outside the image.
  [[nodiscard]] bool at(const cv::Point& pixel) const;

  /// The mask as an image, built anew by each call: CV_8UC1, 255 on the object and 0 elsewhere.
  [[nodiscard]] cv::Mat whole() const;

 private:
  cv::Size image_size_;
  cv::Point offset_;
  cv::Mat pixels_;
};

}  // namespace v2
}  // namespace synthetic_dataset
