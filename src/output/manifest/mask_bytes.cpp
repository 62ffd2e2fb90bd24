#include "output/manifest/mask_bytes.h"

#include <algorithm>
#include <cstdint>

#include <opencv2/core.hpp>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

void append(std::uint64_t number, std::string& bytes) {
  for (; number >= 0x80U; number >>= 7U) bytes += static_cast<char>(0x80U | (number & 0x7FU));
  bytes += static_cast<char>(number);
}

/// Reads numbers one after another from a string of bytes.
class Numbers {
 public:
  explicit Numbers(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] bool isAtEnd() const { return at_ == bytes_.size(); }

  std::int64_t next() {
    std::uint64_t number = 0;
    for (unsigned shift = 0; shift < 35; shift += 7) {  // 35 bits: more than any image has pixels
      if (isAtEnd()) break;
      const auto byte = static_cast<unsigned char>(bytes_[at_++]);
      number |= static_cast<std::uint64_t>(byte & 0x7FU) << shift;
      if (byte < 0x80U) return static_cast<std::int64_t>(number);
    }
    throw Error("a mask in the manifest is damaged");
  }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace

std::string maskBytes(const Mask& mask) {
  std::string bytes;
  const cv::Rect bounds = mask.bounds();
  for (const int number : {bounds.x, bounds.y, bounds.width, bounds.height}) {
    append(static_cast<std::uint64_t>(number), bytes);
  }
  uchar last = 0;
  std::uint64_t run = 0;
  for (int row = 0; row < bounds.height; ++row) {
    const uchar* pixel = mask.pixels().ptr(row);
    for (const uchar* const end = pixel + bounds.width; pixel != end;) {
      const uchar* const next =
          std::find_if(pixel, end, [last](uchar each) { return (each != 0) != (last != 0); });
      run += static_cast<std::uint64_t>(next - pixel);
      pixel = next;
      if (pixel == end) break;
      append(run, bytes);
      run = 0;
      last = last == 0 ? 255 : 0;
    }
  }
  if (run > 0) append(run, bytes);
  return bytes;
}

Mask maskOfBytes(std::string_view bytes, const cv::Size& image_size) {
  Numbers numbers(bytes);
  const std::int64_t left = numbers.next();
  const std::int64_t top = numbers.next();
  const std::int64_t width = numbers.next();
  const std::int64_t height = numbers.next();
  if (left + width > image_size.width || top + height > image_size.height) {
    throw Error("a mask in the manifest is larger than its image");
  }
  if (width == 0 || height == 0) return Mask(image_size);
  cv::Mat part(static_cast<int>(height), static_cast<int>(width), CV_8UC1, cv::Scalar(0));
  const auto count = static_cast<std::int64_t>(part.total());
  std::int64_t at = 0;
  for (bool is_on = false; !numbers.isAtEnd(); is_on = !is_on) {
    const std::int64_t run = numbers.next();
    if (run > count - at) throw Error("a mask in the manifest has more pixels than its box");
    if (is_on) std::fill_n(part.data + at, run, uchar{255});
    at += run;
  }
  if (at != count) throw Error("a mask in the manifest has fewer pixels than its box");
  return {part, cv::Point(static_cast<int>(left), static_cast<int>(top)), image_size};
}

}  // namespace synthetic_dataset::output
