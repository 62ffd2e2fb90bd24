#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Geometry>

#include "base/random/random_source.h"
#include "randomize/appearance/variety/flat_index.h"

namespace synthetic_dataset::randomize {

/// Something printed on one side of a part: lines that look like writing, or a sign.
class Print {
 public:
  /// @param box_M  of the part
  /// @param ink  sRGB-encoded
  Print(const Eigen::AlignedBox3f& box_M, const Eigen::Vector3f& ink, base::RandomSource& random);

  /// The amount of ink at a place of the part, 0 .. 1.
  [[nodiscard]] float inkAt(const Eigen::Vector3f& p_M) const;

  [[nodiscard]] const Eigen::Vector3f& ink() const { return ink_; }

 private:
  static constexpr int kColumns = 48;
  static constexpr int kRows = 32;

  void write(base::RandomSource& random);
  void drawSign(base::RandomSource& random);
  [[nodiscard]] std::uint8_t& cell(int column, int row) {
    return cells_[flatIndex(row, column, kColumns)];
  }
  [[nodiscard]] float at(int column, int row) const;

  Eigen::Vector3f middle_M_;
  Eigen::Vector3f outward_;
  Eigen::Vector3f right_;
  float depth_ = 0.0F;  ///< how far outward a place must be to count as on that side [m]
  float width_ = 0.0F;
  float height_ = 0.0F;
  Eigen::Vector3f ink_;
  std::array<std::uint8_t, std::size_t{kColumns} * kRows> cells_{};
};

}  // namespace synthetic_dataset::randomize
