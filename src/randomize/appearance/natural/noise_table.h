#pragma once

#include <cstdint>
#include <vector>

namespace synthetic_dataset::randomize::natural {

/// Noise that repeats, -127 .. 127 with a standard deviation of about 42. Each octave is as strong
/// as the others, as in photographs (Field 1987): its power falls off by the square of the
/// frequency.
class NoiseTable {
 public:
  static constexpr int kSide = 512;

  /// @param values  kSide times kSide
  explicit NoiseTable(std::vector<std::int8_t> values) : values_(std::move(values)) {}

  [[nodiscard]] int at(int x, int y) const {
    return values_[static_cast<std::size_t>(((y & (kSide - 1)) << 9) | (x & (kSide - 1)))];
  }

  /// Between the table's places: x and y in 1/256 of them.
  [[nodiscard]] int smoothAt(int x, int y) const;

 private:
  std::vector<std::int8_t> values_;
};

/// Which octaves there are, by the longest.
enum class Waves {
  kBroad,    ///< 256 places and shorter
  kMedium,   ///< 64
  kFine,     ///< 16
  kGrain,    ///< 4
  kStreaks,  ///< 64 across, and 16 times as long along x
};

[[nodiscard]] const NoiseTable& noise(Waves waves);

}  // namespace synthetic_dataset::randomize::natural
