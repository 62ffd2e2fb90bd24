#pragma once

#include <cstdint>
#include <vector>

namespace synthetic_dataset::randomize::natural {

/// Noise that repeats, -127 .. 127 with a standard deviation of about 42. All octaves are equally
/// strong, as in photographs (Field 1987): the power falls off with the square of the frequency.
class NoiseTable {
 public:
  static constexpr int kSide = 512;

  /// @param values  kSide times kSide
  explicit NoiseTable(std::vector<std::int8_t> values) : values_(std::move(values)) {}

  [[nodiscard]] int at(int x, int y) const {
    return values_[static_cast<std::size_t>(((y & (kSide - 1)) << 9) | (x & (kSide - 1)))];
  }

  /// Interpolates between the table's places: x and y in 1/256 of a place.
  [[nodiscard]] int smoothAt(int x, int y) const;

 private:
  std::vector<std::int8_t> values_;
};

/// Which octaves a table contains, named after the longest.
enum class Waves {
  kBroad,    ///< 256 places and shorter
  kMedium,   ///< 64
  kFine,     ///< 16
  kGrain,    ///< 4
  kStreaks,  ///< 64 across, and 16 times as long along x
};

[[nodiscard]] const NoiseTable& noise(Waves waves);

}  // namespace synthetic_dataset::randomize::natural
