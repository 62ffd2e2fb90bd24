#include "render/shadows/shadow_lookup.h"

#include <array>

#include "render/shadows/map_row.h"
#include "render/shadows/shadow_projection.h"

namespace synthetic_dataset::render {
namespace {

/// The product of a row of a matrix with points.
Lanes times(const Eigen::Matrix4f& matrix, int row, const Lanes3& point) {
  return lanes(matrix(row, 0)) * point.x + lanes(matrix(row, 1)) * point.y +
         lanes(matrix(row, 2)) * point.z + lanes(matrix(row, 3));
}

}  // namespace

/// Four points in a map.
struct ShadowLookup::FourInMap {
  Lanes column, row, depth;
  Lanes is_within;        ///< a mask
  Lanes depth_by_column;  ///< as in PlaceInMap; set only for soft edges
  Lanes depth_by_row;
};

ShadowLookup::ShadowLookup(const CastShadow& shadow, const MapDepths::Assembled& depths,
                           bool from_point)
    : depths_(depths.depths()),
      row_step_(depths_.step1()),
      size_(static_cast<float>(depths_.cols)),
      texel_(static_cast<float>(shadow.texel)),
      from_point_(from_point) {
  const double half = 0.5 * depths_.cols;
  Eigen::Matrix4d map_from_shadow = Eigen::Matrix4d::Identity();
  map_from_shadow.row(0) = Eigen::Vector4d(half, 0.0, 0.0, half);
  map_from_shadow.row(1) = Eigen::Vector4d(0.0, half, 0.0, half);
  const Eigen::Matrix4d map_from_camera = map_from_shadow * shadow.shadow_from_camera;
  map_from_camera_ = map_from_camera.cast<float>();
  if (!shadow.isSoft()) return;
  planes_from_camera_ = Eigen::Matrix4d(map_from_camera.inverse().transpose()).cast<float>();
  soft_edges_.emplace(depths, shadow.softness);
}

Lanes ShadowLookup::ahead(const Lanes3& position_C) const {
  return times(map_from_camera_, 3, position_C);
}

/// @param raised  the place at which the surface is compared
ShadowLookup::FourInMap ShadowLookup::find(const Lanes3& raised, const Lanes3& normal,
                                           const Lanes& n_dot_l, const Lanes& wanted) const {
  const Lanes zero = lanes(0.0F);
  const Lanes one = lanes(1.0F);
  FourInMap four;
  four.column = times(map_from_camera_, 0, raised);
  four.row = times(map_from_camera_, 1, raised);
  four.depth = times(map_from_camera_, 2, raised);
  // Nothing outside the map is in shadow.
  four.is_within = wanted;
  if (from_point_) {
    const Lanes w = times(map_from_camera_, 3, raised);
    const Lanes inverse = one / w;
    four.column = four.column * inverse;
    four.row = four.row * inverse;
    four.depth = four.depth * inverse;
    four.is_within = four.is_within & (w > zero);
  }
  four.depth = cv::v_min(four.depth, one);
  const Lanes size = lanes(size_);
  four.is_within = four.is_within & (four.column >= zero) & (four.column <= size) &
                   (four.row >= zero) & (four.row <= size);
  if (!soft_edges_) return four;
  // The plane through the point, in the map. Its slope is reduced where light grazes it, as it is
  // unreliable there.
  constexpr float kGrazing = 0.2F;
  const Lanes away = zero - dot(normal, raised);
  const auto part = [&](int row) {
    return dot(lanes(Eigen::Vector3f(planes_from_camera_.block<1, 3>(row, 0))), normal) +
           lanes(planes_from_camera_(row, 3)) * away;
  };
  const Lanes by_depth = part(2);
  const Lanes is_flat = cv::v_abs(by_depth) > lanes(1e-12F);
  const Lanes factor =
      cv::v_min(n_dot_l * lanes(1.0F / kGrazing), one) / cv::v_select(is_flat, by_depth, one);
  four.depth_by_column = (zero - part(0) * factor) & is_flat;
  four.depth_by_row = (zero - part(1) * factor) & is_flat;
  return four;
}

Lanes ShadowLookup::passing(const Lanes3& position_C, const Lanes3& normal, const Lanes& n_dot_l,
                            const Lanes& distance, const Lanes& wanted) const {
  // A surface is compared slightly above itself, so that it does not shade itself: by about a
  // texel, and by more in grazing light. With soft edges less is enough, as its slope in the map is
  // known.
  const Lanes texel = from_point_ ? lanes(texel_) * distance : lanes(texel_);
  const Lanes slope = cv::v_sqrt(cv::v_max(lanes(1.0F) - n_dot_l * n_dot_l, lanes(0.0F)));
  const Lanes raise = soft_edges_ ? lanes(static_cast<float>(kSoftShadowRaise))
                                  : lanes(static_cast<float>(kShadowRaise)) +
                                        lanes(static_cast<float>(kGrazingShadowRaise)) * slope;
  const FourInMap four = find(position_C + normal * (texel * raise), normal, n_dot_l, wanted);
  const int bits = cv::v_signmask(four.is_within);
  using Four = std::array<float, kLaneCount>;
  Four columns{}, rows{}, depths{}, by_column{}, by_row{}, result{};
  cv::v_store(columns.data(), four.column);
  cv::v_store(rows.data(), four.row);
  cv::v_store(depths.data(), four.depth);
  if (soft_edges_) {
    cv::v_store(by_column.data(), four.depth_by_column);
    cv::v_store(by_row.data(), four.depth_by_row);
  }
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    if ((bits >> i & 1) == 0) {
      result[i] = 1.0F;
    } else if (soft_edges_) {
      result[i] = soft_edges_->passing({columns[i], rows[i], depths[i], by_column[i], by_row[i]});
    } else {
      result[i] = passingAt(columns[i], rows[i], depths[i]);
    }
  }
  return cv::v_load(result.data());
}

float ShadowLookup::passingAt(float column, float row, float depth) const {
  // Texels' centres are half a texel from their edges.
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
      add(MapRow(depths_, first_row - 1 + static_cast<int>(i)).four(first_column - 1), i);
    }
  }
  constexpr float kSquare = 9.0F;
  return cv::v_reduce_sum(sum) / kSquare;
}

}  // namespace synthetic_dataset::render
