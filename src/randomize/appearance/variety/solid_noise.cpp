#include "randomize/appearance/variety/solid_noise.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/random/random_seed.h"
#include "randomize/appearance/variety/flat_index.h"

namespace synthetic_dataset::randomize {
namespace {

/// A coarse lattice of random numbers, interpolated.
class LatticeNoise {
 public:
  LatticeNoise(int cells, std::uint64_t seed) : cells_(cells) {
    numbers_.resize(flatIndex(cells * cells, 0, cells));
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      numbers_[i] = static_cast<float>(base::mixedBits(seed + i * base::kCounterStep) >> 40);
    }
  }

  /// @param x, y, z  0 .. 1
  [[nodiscard]] float at(float x, float y, float z) const {
    const auto [x0, x1, a] = cell(x);
    const auto [y0, y1, b] = cell(y);
    const auto [z0, z1, c] = cell(z);
    const auto row = [&, x0 = x0, x1 = x1, a = a](int j, int k) {
      return number(x0, j, k) + a * (number(x1, j, k) - number(x0, j, k));
    };
    const float near = row(y0, z0) + b * (row(y1, z0) - row(y0, z0));
    const float far = row(y0, z1) + b * (row(y1, z1) - row(y0, z1));
    return near + c * (far - near);
  }

 private:
  struct Cell {
    int low;
    int high;
    float share;
  };

  [[nodiscard]] Cell cell(float place) const {
    const float scaled = place * static_cast<float>(cells_);
    const int low = static_cast<int>(scaled);
    const float t = scaled - static_cast<float>(low);
    return {low % cells_, (low + 1) % cells_, t * t * (3.0F - 2.0F * t)};
  }
  [[nodiscard]] float number(int i, int j, int k) const {
    return numbers_[flatIndex(k * cells_ + j, i, cells_)];
  }

  int cells_;
  std::vector<float> numbers_;
};

/// Replaces each value by the share of all values that are smaller, as a byte.
std::vector<std::uint8_t> equalised(const std::vector<float>& values) {
  constexpr std::size_t kBins = 4096;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const float scale = static_cast<float>(kBins - 1) / std::max(*high - *low, 1e-9F);
  const auto bin = [&, low = *low](float value) {
    return static_cast<std::size_t>((value - low) * scale);
  };
  std::vector<std::size_t> below(kBins, 0);
  for (const float value : values) ++below[bin(value)];
  std::size_t sum = 0;
  for (std::size_t& count : below) {
    const std::size_t here = count;
    count = sum + here / 2;
    sum += here;
  }
  std::vector<std::uint8_t> result;
  result.reserve(values.size());
  for (const float value : values) {
    result.push_back(static_cast<std::uint8_t>(255 * below[bin(value)] / values.size()));
  }
  return result;
}

}  // namespace

const SolidNoise& SolidNoise::shared() {
  static const SolidNoise noise;
  return noise;
}

SolidNoise::SolidNoise() {
  const std::array<LatticeNoise, 4> octaves = {LatticeNoise(4, 1), LatticeNoise(8, 2),
                                               LatticeNoise(16, 3), LatticeNoise(32, 4)};
  std::vector<float> sums;
  sums.reserve(flatIndex(kSide * kSide, 0, kSide));
  constexpr float kStep = 1.0F / kSide;
  for (int k = 0; k < kSide; ++k) {
    for (int j = 0; j < kSide; ++j) {
      for (int i = 0; i < kSide; ++i) {
        float sum = 0.0F;
        float height = 1.0F;
        for (const LatticeNoise& octave : octaves) {
          sum += height * octave.at(kStep * static_cast<float>(i), kStep * static_cast<float>(j),
                                    kStep * static_cast<float>(k));
          height *= 0.6F;
        }
        sums.push_back(sum);
      }
    }
  }
  samples_ = equalised(sums);
}

float SolidNoise::at(const Eigen::Vector3f& place) const {
  constexpr int kMask = kSide - 1;
  std::array<int, 3> low{};
  std::array<int, 3> high{};
  std::array<float, 3> share{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // Made positive, so that a cast rounds down, which is quicker than std::floor.
    constexpr float kFarAway = 64.0F * kSide;
    const float scaled = place[static_cast<Eigen::Index>(axis)] * kSide + kFarAway;
    const int floor = static_cast<int>(scaled);
    share[axis] = scaled - static_cast<float>(floor);
    low[axis] = floor & kMask;
    high[axis] = (low[axis] + 1) & kMask;
  }
  const auto row = [&](int j, int k) {
    const std::size_t first = flatIndex(k * kSide + j, 0, kSide);
    const auto a = static_cast<float>(samples_[first + static_cast<std::size_t>(low[0])]);
    const auto b = static_cast<float>(samples_[first + static_cast<std::size_t>(high[0])]);
    return a + share[0] * (b - a);
  };
  const float near = row(low[1], low[2]) + share[1] * (row(high[1], low[2]) - row(low[1], low[2]));
  const float far =
      row(low[1], high[2]) + share[1] * (row(high[1], high[2]) - row(low[1], high[2]));
  return (near + share[2] * (far - near)) * (1.0F / 255.0F);
}

}  // namespace synthetic_dataset::randomize
