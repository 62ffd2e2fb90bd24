#include "render/shadows/shadow_lookup.h"

#include <algorithm>
#include <array>

#include "render/shadows/shadow_projection.h"

namespace synthetic_dataset::render {
namespace {

/// A row of a matrix times points.
Lanes times(const Eigen::Matrix4f& matrix, int row, const Lanes3& point) {
  return lanes(matrix(row, 0)) * point.x + lanes(matrix(row, 1)) * point.y +
         lanes(matrix(row, 2)) * point.z + lanes(matrix(row, 3));
}

/// Four texels of a row, the last ones again where the map ends.
Lanes texels(const cv::Mat& depths, int column, int row) {
  const float* from = depths.ptr<float>(std::clamp(row, 0, depths.rows - 1));
  if (column >= 0 && column + kLaneCount <= depths.cols) return cv::v_load(from + column);
  std::array<float, kLaneCount> some{};
  for (int i = 0; i < kLaneCount; ++i) {
    some[static_cast<std::size_t>(i)] = from[std::clamp(column + i, 0, depths.cols - 1)];
  }
  return cv::v_load(some.data());
}

}  // namespace

ShadowLookup::ShadowLookup(const cv::Mat& depths, const Eigen::Matrix4d& shadow_from_camera,
                           double texel, bool is_lamp)
    : depths_(depths),
      row_step_(depths.step1()),
      size_(static_cast<float>(depths.cols)),
      texel_(static_cast<float>(texel)),
      is_lamp_(is_lamp) {
  const double half = 0.5 * depths.cols;
  Eigen::Matrix4d map_from_shadow = Eigen::Matrix4d::Identity();
  map_from_shadow.row(0) = Eigen::Vector4d(half, 0.0, 0.0, half);
  map_from_shadow.row(1) = Eigen::Vector4d(0.0, half, 0.0, half);
  map_from_camera_ = (map_from_shadow * shadow_from_camera).cast<float>();
}

Lanes ShadowLookup::passing(const Lanes3& position_C, const Lanes3& normal, const Lanes& n_dot_l,
                            const Lanes& distance, const Lanes& wanted) const {
  const Lanes zero = lanes(0.0F);
  const Lanes one = lanes(1.0F);
  // A surface is compared a little above itself, by about a texel, more at grazing light.
  const Lanes texel = is_lamp_ ? lanes(texel_) * distance : lanes(texel_);
  const Lanes slope = cv::v_sqrt(cv::v_max(one - n_dot_l * n_dot_l, zero));
  const Lanes raise = lanes(static_cast<float>(kShadowRaise)) +
                      lanes(static_cast<float>(kGrazingShadowRaise)) * slope;
  const Lanes3 raised = position_C + normal * (texel * raise);
  Lanes column = times(map_from_camera_, 0, raised);
  Lanes row = times(map_from_camera_, 1, raised);
  Lanes depth = times(map_from_camera_, 2, raised);
  // Nothing is in the shadow of what lies outside of the map.
  Lanes is_within = wanted;
  if (is_lamp_) {
    const Lanes w = times(map_from_camera_, 3, raised);
    const Lanes inverse = one / w;
    column = column * inverse;
    row = row * inverse;
    depth = depth * inverse;
    is_within = is_within & (w > zero);
  }
  const Lanes size = lanes(size_);
  is_within = is_within & (column >= zero) & (column <= size) & (row >= zero) & (row <= size);
  const int bits = cv::v_signmask(is_within);
  std::array<float, kLaneCount> columns{};
  std::array<float, kLaneCount> rows{};
  std::array<float, kLaneCount> depths{};
  std::array<float, kLaneCount> result{};
  cv::v_store(columns.data(), column);
  cv::v_store(rows.data(), row);
  cv::v_store(depths.data(), cv::v_min(depth, one));
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    result[i] = (bits >> i & 1) != 0 ? passingAt(columns[i], rows[i], depths[i]) : 1.0F;
  }
  return cv::v_load(result.data());
}

float ShadowLookup::passingAt(float column, float row, float depth) const {
  // Texels' centres lie half a texel from their edges.
  const auto first_column = static_cast<int>(column + 0.5F) - 1;
  const auto first_row = static_cast<int>(row + 0.5F) - 1;
  const float across = column - 0.5F - static_cast<float>(first_column);
  const float down = row - 0.5F - static_cast<float>(first_row);
  const Lanes share(1.0F - across, 1.0F, 1.0F, across);
  const std::array<float, 4> rows = {1.0F - down, 1.0F, 1.0F, down};
  const Lanes reference = lanes(depth);
  Lanes sum = lanes(0.0F);
  const auto add = [&](const Lanes& depths, std::size_t i) {
    sum += (share & (reference <= depths)) * lanes(rows[i]);
  };
  if (first_column >= 1 && first_column + 3 <= depths_.cols && first_row >= 1 &&
      first_row + 3 <= depths_.rows) {
    const float* from = depths_.ptr<float>(first_row - 1, first_column - 1);
    for (std::size_t i = 0; i < rows.size(); ++i) add(cv::v_load(from + i * row_step_), i);
  } else {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      add(texels(depths_, first_column - 1, first_row - 1 + static_cast<int>(i)), i);
    }
  }
  constexpr float kSquare = 9.0F;
  return cv::v_reduce_sum(sum) / kSquare;
}

}  // namespace synthetic_dataset::render
