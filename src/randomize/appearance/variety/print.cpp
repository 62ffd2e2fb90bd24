#include "randomize/appearance/variety/print.h"

#include <algorithm>
#include <cmath>

namespace synthetic_dataset::randomize {

Print::Print(const Eigen::AlignedBox3f& box_M, const Eigen::Vector3f& ink,
             base::RandomSource& random)
    : ink_(ink) {
  const Eigen::Vector3f size = box_M.sizes();
  // Towards one of four sides, or a little off: works on a box's side as well as around a drum.
  const double angle = 0.5 * M_PI * static_cast<double>(random.index(4)) + 0.3 * random.normal();
  outward_ = Eigen::Vector3f(static_cast<float>(std::cos(angle)),
                             static_cast<float>(std::sin(angle)), 0.0F);
  right_ = {-outward_.y(), outward_.x(), 0.0F};
  const float across = std::abs(right_.x()) * size.x() + std::abs(right_.y()) * size.y();
  const float deep = std::abs(outward_.x()) * size.x() + std::abs(outward_.y()) * size.y();
  depth_ = 0.1F * deep;
  width_ = static_cast<float>(random.uniform(0.25, 0.7)) * across;
  height_ = std::min(static_cast<float>(random.uniform(0.3, 0.9)) * width_, 0.5F * size.z());
  middle_M_ = box_M.center();
  middle_M_ += 0.15F * across * static_cast<float>(random.uniform(-1.0, 1.0)) * right_;
  middle_M_.z() += 0.5F * (size.z() - height_) * static_cast<float>(random.uniform(-0.8, 0.8));
  if (random.index(3) == 0) {
    drawSign(random);
  } else {
    write(random);
  }
}

/// Rows of strokes with spaces between them.
void Print::write(base::RandomSource& random) {
  const int lines = 1 + static_cast<int>(random.index(4));
  const int pitch = kRows / lines;
  const int letter = std::max(3, (3 * pitch) / 8);
  for (int line = 0; line < lines; ++line) {
    const int top = line * pitch + pitch / 6;
    const int bottom = top + (2 * pitch) / 3;
    int left = static_cast<int>(random.index(6));
    const int end = kColumns - static_cast<int>(random.index(16));
    while (left + letter < end) {
      const std::uint64_t strokes = random.bits();
      const int stroke = std::max(1, letter / 3);
      for (int row = top; row < bottom; ++row) {
        const auto third = static_cast<unsigned>(3 * (row - top) / std::max(bottom - top, 1));
        for (int column = left; column < left + letter; ++column) {
          const bool is_edge = column < left + stroke || row < top + stroke;
          const auto part = static_cast<unsigned>((column - left) / stroke);
          const bool is_inner = ((strokes >> (3U * third + part)) & 1U) != 0;
          if ((is_edge && ((strokes >> 20U) & 3U) != 0) || is_inner) cell(column, row) = 255;
        }
      }
      left += letter + 1 + ((strokes >> 32U) % 6 == 0 ? letter : 0);
    }
  }
}

/// A disc, a ring, a triangle or a bar.
void Print::drawSign(base::RandomSource& random) {
  const std::size_t kind = random.index(4);
  const double size = random.uniform(0.3, 0.5) * kRows;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const double x = column + 0.5 - 0.5 * kColumns;
      const double y = row + 0.5 - 0.5 * kRows;
      const double radius = std::hypot(x, y);
      bool is_inked = radius < size;
      if (kind == 1) is_inked = is_inked && radius > 0.65 * size;
      if (kind == 2) is_inked = std::abs(y) < size && std::abs(x) < 0.6 * (y + size);
      if (kind == 3) is_inked = std::abs(y) < 0.5 * size && std::abs(x) < 0.46 * kColumns;
      if (is_inked) cell(column, row) = 255;
    }
  }
}

float Print::at(int column, int row) const {
  if (column < 0 || row < 0 || column >= kColumns || row >= kRows) return 0.0F;
  return static_cast<float>(cells_[flatIndex(row, column, kColumns)]) / 255.0F;
}

float Print::inkAt(const Eigen::Vector3f& p_M) const {
  const Eigen::Vector3f off = p_M - middle_M_;
  const float x = right_.dot(off) / width_ + 0.5F;
  const float y = 0.5F - off.z() / height_;
  if (x <= 0.0F || y <= 0.0F || x >= 1.0F || y >= 1.0F || outward_.dot(off) < depth_) return 0.0F;
  const float column = x * kColumns - 0.5F;
  const float row = y * kRows - 0.5F;
  const int left = static_cast<int>(std::floor(column));
  const int top = static_cast<int>(std::floor(row));
  const float a = column - static_cast<float>(left);
  const float b = row - static_cast<float>(top);
  const float above = at(left, top) + a * (at(left + 1, top) - at(left, top));
  const float below = at(left, top + 1) + a * (at(left + 1, top + 1) - at(left, top + 1));
  return above + b * (below - above);
}

}  // namespace synthetic_dataset::randomize
