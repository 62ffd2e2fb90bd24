#pragma once

#include <functional>
#include <vector>

#include <opencv2/core/types.hpp>

#include "synthetic_dataset/camera_model.h"

namespace synthetic_dataset::render {

/// The place where a ray meets a plane that is divided into cells; the integer parts of the
/// coordinates are its cell.
struct PlacedRay {
  float column = 0.0F;
  float row = 0.0F;
  int ray = 0;  ///< its index among the caller's
};

/// Rays in the order of the cells in which they meet a plane, so that within each row of cells
/// those that a triangle may cover are contiguous.
struct RayGrid {
  /// The number of padding rays (at no place) behind the last one, as four lanes are processed at
  /// once.
  static constexpr int kSpare = 4;

  Intrinsics intrinsics;  ///< of the plane, in cells
  cv::Size cells;
  std::vector<float> columns;  ///< of each ray
  std::vector<float> rows;     ///< of each ray
  std::vector<int> rays;       ///< the index of each among the caller's
  std::vector<int> first;      ///< index of each cell's first ray, row by row; then their number

  [[nodiscard]] std::size_t count() const { return rays.size(); }
};

/// @param intrinsics  of the plane, in cells
/// @param rays  rays that meet the plane within the cells
[[nodiscard]] RayGrid makeRayGrid(const Intrinsics& intrinsics, const cv::Size& cells,
                                  const std::vector<PlacedRay>& rays);

/// Rays in the order of the picture's rows that they belong to, each row's from left to right.
struct RowRayGrid {
  /// The bounds of the places of a row's rays [cell].
  struct Bounds {
    float left, top, right, bottom;

    void extend(const Bounds& other);
  };

  RayGrid grid;  ///< its `first` is per row of the picture, not per cell
  std::vector<Bounds> rows;
};

/// @param intrinsics  of the plane, in cells
/// @param rows  the number of the picture's rows
/// @param row_of  the row to which one of the caller's rays belongs
[[nodiscard]] RowRayGrid makeRowRayGrid(const Intrinsics& intrinsics, const cv::Size& cells,
                                        const std::vector<PlacedRay>& rays, int rows,
                                        const std::function<int(int ray)>& row_of);

}  // namespace synthetic_dataset::render
