#include "randomize/appearance/natural/lens.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "randomize/appearance/natural/noise_table.h"
#include "randomize/appearance/natural/quick_draws.h"

namespace synthetic_dataset::randomize::natural {
namespace {

using Curve = std::array<std::uint8_t, 256>;

/// @param gain  in 1/256
/// @param middle  how much the mid-tones are raised, in 1/256
/// @param contrast  strength of the S-curve, in 1/256
Curve drawnCurve(int gain, int middle, int contrast) {
  Curve curve{};
  for (int i = 0; i < 256; ++i) {
    int value = std::min(255, i * gain / 256);
    value += value * (255 - value) / 255 * middle / 256;
    const int s_curve = value * value / 255 * (765 - 2 * value) / 255;
    curve[static_cast<std::size_t>(i)] = byteOf(value + (s_curve - value) * contrast / 256);
  }
  return curve;
}

int meanOf(const Canvas& canvas) {
  std::int64_t sum = 0;
  int count = 0;
  for (int y = 0; y < canvas.rows; y += 4) {
    for (int x = 0; x < canvas.cols; x += 4, ++count) sum += canvas(y, x)[1];
  }
  return static_cast<int>(sum / count);
}

/// Imitates a camera's exposure, which keeps a picture from being too dark or too bright overall.
std::array<Curve, 3> drawCurves(const Canvas& canvas, base::RandomSource& random) {
  const int wanted = between(random, 75, 155);
  const int exposure = std::clamp(256 * wanted / std::max(1, meanOf(canvas)), 150, 480);
  const int warmth = exposure * between(random, -22, 26) / 256;  // above 0: more red than blue
  const int green = between(random, -5, 5);
  const int middle = between(random, -30, 60);
  const int contrast = between(random, -20, 120);
  return {drawnCurve(exposure - warmth, middle, contrast),
          drawnCurve(exposure + green, middle, contrast),
          drawnCurve(exposure + warmth, middle, contrast)};
}

/// Blurs a row with the weights 1 2 1.
void spreadRow(const std::uint8_t* row, int bytes, std::uint16_t* spread) {
  const auto sum = [&](int left, int i, int right) {
    return static_cast<std::uint16_t>(row[left] + 2 * row[i] + row[right]);
  };
  for (int i = 0; i < 4; ++i) spread[i] = sum(i, i, i + 4);
  for (int i = 4; i < bytes - 4; ++i) spread[i] = sum(i - 4, i, i + 4);
  for (int i = bytes - 4; i < bytes; ++i) spread[i] = sum(i - 4, i, i);
}

void spreadColumn(const std::uint16_t* above, const std::uint16_t* here, const std::uint16_t* under,
                  int bytes, std::uint8_t* spread) {
  for (int i = 0; i < bytes; ++i) {
    spread[i] = static_cast<std::uint8_t>((above[i] + 2 * here[i] + under[i] + 8) >> 4);
  }
}

/// How much darker each place along one axis is, in 1/256, by the squared distance from the middle.
std::vector<int> darkened(int count, int corners) {
  std::vector<int> shares;
  for (int i = 0; i < count; ++i) {
    const int far = 2 * i - count;
    shares.push_back(
        static_cast<int>(std::int64_t{far} * far * corners / (2 * std::int64_t{count} * count)));
  }
  return shares;
}

/// A running mean along a row.
void softenRow(cv::Vec4b* row, int count, int radius, std::vector<cv::Vec4b>& copy) {
  std::copy(row, row + count, copy.begin());
  const auto at = [&](int i) -> const cv::Vec4b& {
    return copy[static_cast<std::size_t>(std::clamp(i, 0, count - 1))];
  };
  std::array<int, 3> sums{};
  for (int i = -radius; i <= radius; ++i) {
    for (int c = 0; c < 3; ++c) sums[static_cast<std::size_t>(c)] += at(i)[c];
  }
  const int factor = 65536 / (2 * radius + 1);
  for (int i = 0; i < count; ++i) {
    const cv::Vec4b& next = at(i + radius + 1);
    const cv::Vec4b& last = at(i - radius);
    for (int c = 0; c < 3; ++c) {
      int& sum = sums[static_cast<std::size_t>(c)];
      row[i][c] = static_cast<std::uint8_t>((sum * factor + 32768) >> 16);
      sum += next[c] - last[c];
    }
  }
}

/// Running means along all columns, row by row.
void softenColumns(Canvas& canvas, int radius) {
  const Canvas copy = canvas.clone();
  const int bytes = 4 * canvas.cols;
  const auto at = [&](int y) { return copy.ptr<std::uint8_t>(std::clamp(y, 0, copy.rows - 1)); };
  std::vector<int> sums(static_cast<std::size_t>(bytes), 0);
  for (int y = -radius; y <= radius; ++y) {
    const std::uint8_t* row = at(y);
    for (int i = 0; i < bytes; ++i) sums[static_cast<std::size_t>(i)] += row[i];
  }
  const int factor = 65536 / (2 * radius + 1);
  for (int y = 0; y < canvas.rows; ++y) {
    const std::uint8_t* next = at(y + radius + 1);
    const std::uint8_t* last = at(y - radius);
    auto* row = canvas.ptr<std::uint8_t>(y);
    int* sum = sums.data();
    for (int i = 0; i < bytes; ++i) {
      row[i] = static_cast<std::uint8_t>((sum[i] * factor + 32768) >> 16);
      sum[i] += next[i] - last[i];
    }
  }
}

}  // namespace

void soften(Canvas& canvas, int radius) {
  if (radius <= 0) return;
  std::vector<cv::Vec4b> copy(static_cast<std::size_t>(canvas.cols));
  for (int y = 0; y < canvas.rows; ++y) softenRow(canvas[y], canvas.cols, radius, copy);
  softenColumns(canvas, radius);
}

void develop(Canvas& canvas, base::RandomSource& random) {
  const std::array<Curve, 3> curves = drawCurves(canvas, random);
  const int corners = chance(random, 0.4) ? between(random, 20, 110) : 0;
  const int grain = between(random, 2, 14);
  const int shift = below(random, NoiseTable::kSide);
  const NoiseTable& table = noise(Waves::kGrain);
  const int bytes = 4 * canvas.cols;
  std::array<std::vector<std::uint16_t>, 3> rows;
  for (auto& row : rows) row.resize(static_cast<std::size_t>(bytes));
  spreadRow(canvas.ptr<std::uint8_t>(0), bytes, rows[0].data());
  rows[2] = rows[0];
  std::vector<std::uint8_t> smooth(static_cast<std::size_t>(bytes));
  const std::vector<int> across = darkened(canvas.cols, corners);
  const std::vector<int> along = darkened(canvas.rows, corners);
  for (int y = 0; y < canvas.rows; ++y) {
    // `rows` holds this row, the next and the previous one, in turn.
    const auto now = static_cast<std::size_t>(y % 3);
    const std::size_t next = (now + 1) % 3;
    if (y + 1 < canvas.rows) {
      spreadRow(canvas.ptr<std::uint8_t>(y + 1), bytes, rows[next].data());
    } else {
      rows[next] = rows[now];
    }
    spreadColumn(rows[(now + 2) % 3].data(), rows[now].data(), rows[next].data(), bytes,
                 smooth.data());
    cv::Vec4b* pixels = canvas[y];
    const int of_row = 256 - along[static_cast<std::size_t>(y)];
    for (int x = 0; x < canvas.cols; ++x) {
      const std::uint8_t* value = &smooth[4 * static_cast<std::size_t>(x)];
      const int shade = of_row - across[static_cast<std::size_t>(x)];
      const int noisy = table.at(x + shift, y) * grain >> 7;
      pixels[x] = {byteOf((curves[0][value[0]] * shade >> 8) + noisy),
                   byteOf((curves[1][value[1]] * shade >> 8) + noisy),
                   byteOf((curves[2][value[2]] * shade >> 8) + noisy), 255};
    }
  }
}

}  // namespace synthetic_dataset::randomize::natural
