#include "render/sensor/linear_accumulator.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include <opencv2/core.hpp>

#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace {

/// The size of a block that is compared at once, as most pictures of an exposure are alike in most
/// places.
constexpr int kBlock = 64;  // [byte]

/// Calls visit(first, count) for the bytes of each block of a row.
template <class Visit>
void forBlocks(int bytes, const Visit& visit) {
  for (int first = 0; first < bytes; first += kBlock) {
    visit(first, std::min(kBlock, bytes - first));
  }
}

}  // namespace

void LinearAccumulator::add(const cv::Mat& pixels, double weight) {
  if (first_.empty()) {
    first_ = pixels;
    further_.create(first_.size(), CV_32FC3);
    differs_ = cv::Mat::zeros(first_.rows, first_.cols * 3 / kBlock + 1, CV_8UC1);
    return;
  }
  const auto& linear = linearFromSrgb();
  const auto share = static_cast<float>(weight);
  for (int v = 0; v < first_.rows; ++v) {
    const auto* one = first_.ptr<std::uint8_t>(v);
    const auto* other = pixels.ptr<std::uint8_t>(v);
    auto* further = further_.ptr<float>(v);
    auto* differs = differs_.ptr<std::uint8_t>(v);
    forBlocks(3 * first_.cols, [&](int first, int count) {
      if (std::memcmp(one + first, other + first, static_cast<std::size_t>(count)) == 0) return;
      std::uint8_t& has_differed = differs[first / kBlock];
      if (has_differed == 0) std::fill_n(further + first, count, 0.0F);
      has_differed = 1;
      for (int i = first; i < first + count; ++i) {
        further[i] += share * (linear[other[i]] - linear[one[i]]);
      }
    });
  }
}

cv::Mat LinearAccumulator::result() const {
  cv::Mat picture = first_.clone();
  const auto& linear = linearFromSrgb();
  for (int v = 0; v < picture.rows; ++v) {
    auto* pixels = picture.ptr<std::uint8_t>(v);
    const auto* further = further_.ptr<float>(v);
    const auto* differs = differs_.ptr<std::uint8_t>(v);
    forBlocks(3 * picture.cols, [&](int first, int count) {
      if (differs[first / kBlock] == 0) return;
      for (int i = first; i < first + count; ++i) {
        pixels[i] = srgbFromLinear(linear[pixels[i]] + further[i]);
      }
    });
  }
  return picture;
}

}  // namespace synthetic_dataset::render
