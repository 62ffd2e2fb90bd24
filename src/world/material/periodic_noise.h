#pragma once

#include <cmath>
#include <cstdint>

namespace synthetic_dataset::world {

/// Smooth noise from 0 to 1 over the unit square, that repeats at its edges. A function of the
/// seed and the place alone.
class PeriodicNoise {
 public:
  /// @param cells_u, cells_v  of the coarsest lattice; each octave has twice as many, half as
  /// strong
  PeriodicNoise(std::uint32_t seed, int cells_u, int cells_v, int octaves)
      : seed_(seed), cells_u_(cells_u), cells_v_(cells_v), octaves_(octaves) {}

  [[nodiscard]] float operator()(float u, float v) const {
    float sum = 0.0F;
    float weights = 0.0F;
    float weight = 1.0F;
    for (int octave = 0; octave < octaves_; ++octave, weight *= 0.5F) {
      sum += weight * layer(octave, u, v);
      weights += weight;
    }
    return sum / weights;
  }

  /// A number from 0 to 1 for a place of a grid.
  [[nodiscard]] static float value(std::uint32_t seed, int column, int row) {
    // The finaliser of MurmurHash3 (A. Appleby), over the numbers one after the other.
    std::uint32_t hash = mixed(seed + 0x9E3779B9U);
    hash = mixed(hash ^ static_cast<std::uint32_t>(column));
    hash = mixed(hash ^ static_cast<std::uint32_t>(row) ^ 0x85EBCA6BU);
    return static_cast<float>(hash >> 8U) / 16777215.0F;
  }

 private:
  static std::uint32_t mixed(std::uint32_t h) {
    h = (h ^ (h >> 16U)) * 0x85EBCA6BU;
    h = (h ^ (h >> 13U)) * 0xC2B2AE35U;
    return h ^ (h >> 16U);
  }

  /// Lattice values, joined by cubic steps.
  [[nodiscard]] float layer(int octave, float u, float v) const {
    const int columns = cells_u_ << octave;
    const int rows = cells_v_ << octave;
    const float x = (u - std::floor(u)) * static_cast<float>(columns);
    const float y = (v - std::floor(v)) * static_cast<float>(rows);
    const int i = static_cast<int>(x) % columns;
    const int j = static_cast<int>(y) % rows;
    const float fx = step(x - static_cast<float>(i));
    const float fy = step(y - static_cast<float>(j));
    const std::uint32_t seed = seed_ + 7919U * static_cast<std::uint32_t>(octave);
    const float top = joined(value(seed, i, j), value(seed, (i + 1) % columns, j), fx);
    const float bottom =
        joined(value(seed, i, (j + 1) % rows), value(seed, (i + 1) % columns, (j + 1) % rows), fx);
    return joined(top, bottom, fy);
  }

  static float step(float t) { return t * t * (3.0F - 2.0F * t); }
  static float joined(float a, float b, float share) { return a + (b - a) * share; }

  std::uint32_t seed_;
  int cells_u_;
  int cells_v_;
  int octaves_;
};

}  // namespace synthetic_dataset::world
