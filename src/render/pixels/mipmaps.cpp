#include "render/pixels/mipmaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "sensor/srgb.h"

namespace synthetic_dataset::render {
namespace {

constexpr int kChannels = 4;
constexpr int kAlpha = 3;

/// Which pixels of a line make one of a line of half its length, and how much of it each of them.
struct Taps {
  std::array<int, 3> places{};
  std::array<float, 3> weights{};
};

int halfOf(int length) { return std::max(1, length / 2); }

/// Where a length is odd, pixels of the shorter line cover parts of the longer one's.
std::vector<Taps> tapsOf(int length) {
  const int half = halfOf(length);
  const double scale = static_cast<double>(length) / half;
  std::vector<Taps> taps(static_cast<std::size_t>(half));
  for (int i = 0; i < half; ++i) {
    Taps& tap = taps[static_cast<std::size_t>(i)];
    const double begin = i * scale;
    const int first = static_cast<int>(begin);
    for (int k = 0; k < 3; ++k) {
      const double covered =
          std::min(begin + scale, first + k + 1.0) - std::max(begin, first + k + 0.0);
      tap.places.at(static_cast<std::size_t>(k)) = std::min(first + k, length - 1);
      tap.weights.at(static_cast<std::size_t>(k)) =
          static_cast<float>(std::max(0.0, covered) / scale);
    }
  }
  return taps;
}

const std::array<float, 256>& fractions() {
  static const std::array<float, 256> kTable = [] {
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) table[i] = static_cast<float>(i) / 255.0F;
    return table;
  }();
  return kTable;
}

/// What bytes stand for, and back.
struct Coding {
  PixelMeaning meaning;

  [[nodiscard]] bool isLight(int channel) const {
    return meaning == PixelMeaning::kColour && channel != kAlpha;
  }

  void decode(const std::uint8_t* bytes, int pixels, float* numbers) const {
    const auto& table = meaning == PixelMeaning::kColour ? sensor::linearFromSrgb() : fractions();
    for (int i = 0; i < kChannels * pixels; i += kChannels) {
      for (int c = 0; c < kAlpha; ++c) numbers[i + c] = table[bytes[i + c]];
      numbers[i + kAlpha] = fractions()[bytes[i + kAlpha]];
    }
  }

  [[nodiscard]] std::uint8_t encoded(float number, int channel) const {
    if (isLight(channel)) return sensor::srgbFromLinear(number);
    return static_cast<std::uint8_t>(std::lround(255.0F * number));
  }

  /// @param numbers  CV_32FC4
  [[nodiscard]] cv::Mat encode(const cv::Mat& numbers) const {
    cv::Mat bytes(numbers.size(), CV_8UC4);
    for (int v = 0; v < bytes.rows; ++v) {
      const auto* from = numbers.ptr<float>(v);
      auto* to = bytes.ptr<std::uint8_t>(v);
      for (int i = 0; i < kChannels * bytes.cols; ++i) to[i] = encoded(from[i], i % kChannels);
    }
    return bytes;
  }
};

/// A picture of half the size, from lines that are given one by one.
/// @param line  gives the numbers of a row
template <class Line>
cv::Mat halved(const cv::Size& size, const Line& line) {
  const std::vector<Taps> columns = tapsOf(size.width);
  const std::vector<Taps> rows = tapsOf(size.height);
  cv::Mat half(halfOf(size.height), halfOf(size.width), CV_32FC4);
  std::vector<float> sums(static_cast<std::size_t>(kChannels * size.width));
  for (int v = 0; v < half.rows; ++v) {
    std::fill(sums.begin(), sums.end(), 0.0F);
    const Taps& row = rows[static_cast<std::size_t>(v)];
    for (std::size_t k = 0; k < 3; ++k) {
      if (row.weights[k] <= 0.0F) continue;
      const float* numbers = line(row.places[k]);
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += row.weights[k] * numbers[i];
    }
    auto* to = half.ptr<float>(v);
    for (const Taps& column : columns) {
      for (int c = 0; c < kChannels; ++c, ++to) {
        *to = 0.0F;
        for (std::size_t k = 0; k < 3; ++k) {
          *to +=
              column.weights[k] * sums[static_cast<std::size_t>(kChannels * column.places[k] + c)];
        }
      }
    }
  }
  return half;
}

}  // namespace

std::vector<cv::Mat> mipmapsOf(const cv::Mat& picture, PixelMeaning meaning) {
  const Coding coding{meaning};
  std::vector<cv::Mat> mipmaps;
  if (picture.total() <= 1) return mipmaps;
  std::vector<float> line(static_cast<std::size_t>(kChannels * picture.cols));
  cv::Mat numbers = halved(picture.size(), [&](int v) {
    coding.decode(picture.ptr(v), picture.cols, line.data());
    return line.data();
  });
  mipmaps.push_back(coding.encode(numbers));
  while (numbers.total() > 1) {
    const cv::Mat larger = numbers;
    numbers = halved(larger.size(), [&](int v) { return larger.ptr<float>(v); });
    mipmaps.push_back(coding.encode(numbers));
  }
  return mipmaps;
}

}  // namespace synthetic_dataset::render
