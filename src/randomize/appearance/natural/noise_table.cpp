#include "randomize/appearance/natural/noise_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <utility>

#include "base/random/random_seed.h"

namespace synthetic_dataset::randomize::natural {
namespace {

constexpr int kNoiseSide = NoiseTable::kSide;
using Sums = std::vector<int>;

/// The random number at a lattice point, -127 .. 127.
int latticeValue(int octave, int column, int row) {
  const auto place = static_cast<std::uint64_t>((octave << 20) | (row << 10) | column);
  return static_cast<int>(base::mixedBits((place + 1) * base::kCounterStep) % 255U) - 127;
}

/// Eases from 0 to 256 over a lattice's spacing, flat at both ends.
std::vector<int> easing(int spacing) {
  std::vector<int> shares;
  for (int i = 0; i < spacing; ++i) {
    const int t = i * 256 / spacing;
    shares.push_back(t * t * (768 - 2 * t) / 65536);
  }
  return shares;
}

/// Adds random numbers at lattice points, with interpolation in between.
void addOctave(Sums& sums, int octave, int wide, int high) {
  const std::vector<int> across = easing(wide);
  const std::vector<int> along = easing(high);
  const int columns = kNoiseSide / wide;
  const int rows = kNoiseSide / high;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int next_column = (column + 1) % columns;
      const int next_row = (row + 1) % rows;
      const int a = latticeValue(octave, column, row);
      const int b = latticeValue(octave, next_column, row) - a;
      const int c = latticeValue(octave, column, next_row);
      const int d = latticeValue(octave, next_column, next_row) - c;
      for (int y = 0; y < high; ++y) {
        int* sum = sums.data() + (row * high + y) * kNoiseSide + column * wide;
        for (int x = 0; x < wide; ++x) {
          const int share = across[static_cast<std::size_t>(x)];
          const int above = 256 * a + share * b;
          const int under = 256 * c + share * d;
          sum[x] += (256 * above + along[static_cast<std::size_t>(y)] * (under - above)) / 4096;
        }
      }
    }
  }
}

NoiseTable tableOf(const Sums& sums) {
  std::int64_t total = 0;
  std::int64_t squares = 0;
  for (const int sum : sums) {
    total += sum;
    squares += std::int64_t{sum} * sum;
  }
  const auto count = static_cast<std::int64_t>(sums.size());
  const std::int64_t mean = total / count;
  const std::int64_t variance = squares / count - mean * mean;
  const double deviation = std::sqrt(static_cast<double>(variance));
  constexpr double kDeviation = 42.0;
  const auto factor = static_cast<std::int64_t>(65536.0 * kDeviation / deviation);
  std::vector<std::int8_t> values;
  values.reserve(sums.size());
  for (const int sum : sums) {
    const std::int64_t value = (sum - mean) * factor / 65536;
    values.push_back(
        static_cast<std::int8_t>(std::clamp(value, std::int64_t{-127}, std::int64_t{127})));
  }
  return NoiseTable(std::move(values));
}

std::vector<NoiseTable> makeTables() {
  std::vector<NoiseTable> tables;
  Sums sums(static_cast<std::size_t>(kNoiseSide) * kNoiseSide);
  for (int octave = 0; octave <= 8; ++octave) {
    addOctave(sums, octave, 1 << octave, 1 << octave);
    if (octave == 2 || octave == 4 || octave == 6 || octave == 8) tables.push_back(tableOf(sums));
  }
  std::reverse(tables.begin(), tables.end());
  std::fill(sums.begin(), sums.end(), 0);
  for (int octave = 0; octave <= 6; ++octave) {
    addOctave(sums, 16 + octave, std::min(16 << octave, kNoiseSide), 1 << octave);
  }
  tables.push_back(tableOf(sums));
  return tables;
}

}  // namespace

int NoiseTable::smoothAt(int x, int y) const {
  const int column = x >> 8;
  const int row = y >> 8;
  const int share = x & 255;
  const int above = 256 * at(column, row) + share * (at(column + 1, row) - at(column, row));
  const int under =
      256 * at(column, row + 1) + share * (at(column + 1, row + 1) - at(column, row + 1));
  return (256 * above + (y & 255) * (under - above)) / 65536;
}

const NoiseTable& noise(Waves waves) {
  static const std::vector<NoiseTable> kTables = makeTables();  // in the order of Waves
  return kTables[static_cast<std::size_t>(waves)];
}

}  // namespace synthetic_dataset::randomize::natural
