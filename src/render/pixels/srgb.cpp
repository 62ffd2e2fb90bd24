#include "render/pixels/srgb.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "render/pixels/half.h"
#include "render/sensor/srgb.h"

namespace synthetic_dataset::render {
namespace {

/// The encoded value of each number of 16 bits from 0 to 1.
class HalfEncoder {
 public:
  HalfEncoder() {
    for (std::size_t bits = 0; bits < table_.size(); ++bits) {
      table_[bits] = render::srgbFromLinear(fromHalf(static_cast<std::uint16_t>(bits)));
    }
  }

  [[nodiscard]] std::uint8_t operator()(std::uint16_t bits) const {
    constexpr std::uint16_t kNegative = 0x8000;
    return (bits & kNegative) != 0 ? 0 : table_[std::min<std::size_t>(bits, kOne)];
  }

 private:
  static constexpr std::size_t kOne = 0x3C00;
  std::array<std::uint8_t, kOne + 1> table_{};
};

}  // namespace

Eigen::Vector3f linearFromSrgb(const Eigen::Vector3f& encoded) {
  return encoded.unaryExpr([](float channel) { return render::linearFromSrgb(channel); });
}

Eigen::Vector4f linearFromSrgb(const Eigen::Vector4f& encoded) {
  const Eigen::Vector3f colour = linearFromSrgb(Eigen::Vector3f(encoded.head<3>()));
  return {colour.x(), colour.y(), colour.z(), encoded.w()};
}

void encodeSrgb(const cv::Mat& light, const cv::Mat& wanted, cv::Mat& picture) {
  static const HalfEncoder kEncoder;
  for (int v = 0; v < light.rows; ++v) {
    const auto* from = light.ptr<std::uint16_t>(v);
    const auto* is_wanted = wanted.ptr<std::uint8_t>(v);
    auto* to = picture.ptr<std::uint8_t>(v);
    for (int u = 0; u < light.cols; ++u, from += 4, to += 3) {
      if (is_wanted[u] == 0) continue;
      to[0] = kEncoder(from[2]);
      to[1] = kEncoder(from[1]);
      to[2] = kEncoder(from[0]);
    }
  }
}

}  // namespace synthetic_dataset::render
