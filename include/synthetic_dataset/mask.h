#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset {
inline namespace v2 {

/// Around all pixels of a mask that are not 0 [px]; empty where there are none, or no pixels at
/// all.
///
/// cv::boundingRect of OpenCV 4.6 says too little of narrow shapes whose rows do not begin at
/// multiples of four bytes, as those of parts of an image, or of images of odd widths.
/// @param mask  CV_8UC1, of any size, maybe a part of another image
[[nodiscard]] cv::Rect maskBounds(const cv::Mat& mask);

/// Which pixels of an image belong to an object, held as the smallest part of the image that has
/// them all: memory grows with what is seen, not with the image. A value, whose copies share their
/// pixels, as those of cv::Mat do; nobody changes them.
class Mask {
 public:
  /// Of no image.
  Mask() = default;

  /// No pixel of an image.
  explicit Mask(const cv::Size& image_size) : image_size_(image_size) {}

  /// @param part  CV_8UC1, 255 on the object and 0 elsewhere; what of it is empty at its edges is
  ///     left out, and the rest shared where it is at least half of the part, else copied
  /// @param offset  the pixel of the image at which the part has its first one
  /// @throws Error where the part has another type, or a pixel outside of the image
  Mask(const cv::Mat& part, const cv::Point& offset, const cv::Size& image_size);

  /// Of a part that is the whole image.
  explicit Mask(const cv::Mat& image) : Mask(image, {}, image.size()) {}

  /// Whether no pixel belongs to the object.
  [[nodiscard]] bool empty() const { return pixels_.empty(); }

  /// Around its pixels, each edge of it touching one [px]; empty where there are none.
  [[nodiscard]] cv::Rect bounds() const { return {offset_, pixels_.size()}; }

  /// The part of the image within `bounds()`: CV_8UC1, 255 on the object and 0 elsewhere.
  [[nodiscard]] const cv::Mat& pixels() const { return pixels_; }

  /// The pixel of the image at which `pixels()` has its first one.
  [[nodiscard]] cv::Point offset() const { return offset_; }

  [[nodiscard]] cv::Size imageSize() const { return image_size_; }

  /// How many pixels belong to the object.
  [[nodiscard]] std::int64_t count() const;

  /// Whether a pixel of the image does; false outside of it.
  [[nodiscard]] bool at(const cv::Point& pixel) const;

  /// The mask as an image, made anew at each call: CV_8UC1, 255 on the object and 0 elsewhere.
  [[nodiscard]] cv::Mat whole() const;

 private:
  cv::Size image_size_;
  cv::Point offset_;
  cv::Mat pixels_;
};

}  // namespace v2
}  // namespace synthetic_dataset
