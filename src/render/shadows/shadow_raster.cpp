#include "render/shadows/shadow_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <opencv2/core/fast_math.hpp>

#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {
namespace {

constexpr float kFarthestDepth = 1.0F;
constexpr float kTexelSteps = 256.0F;  // of a texel, to which corners are rounded

/// A corner in the map: column and row, so that texels' centres are whole numbers; depth.
using Corners = std::vector<Eigen::Vector3f>;

/// To the nearest step, half of one away from 0.
float rounded(float texels) {
  const float steps = texels * kTexelSteps;
  // Beyond, numbers of single precision are whole.
  constexpr float kWhole = 0x1p23F;
  if (!(std::abs(steps) < kWhole)) return texels;
  return static_cast<float>(static_cast<int>(steps + std::copysign(0.5F, steps))) / kTexelSteps;
}

Corners cornersOf(const world::Mesh& mesh, const Eigen::Projective3f& map_from_mesh) {
  Corners corners;
  corners.reserve(mesh.positions.size());
  for (const Eigen::Vector3f& position : mesh.positions) {
    const Eigen::Vector3f place = (map_from_mesh.matrix() * position.homogeneous()).hnormalized();
    corners.emplace_back(rounded(place.x() - 0.5F), rounded(place.y() - 0.5F), place.z());
  }
  return corners;
}

/// The texels of a map whose centres are between these places.
cv::Rect texelsBetween(const Eigen::Vector3f& lowest, const Eigen::Vector3f& highest, int size) {
  const float beside = static_cast<float>(size) + 1.0F;
  const auto within = [&](float place) { return std::min(std::max(place, -beside), beside); };
  const cv::Point first(std::max(cvCeil(within(lowest.x())), 0),
                        std::max(cvCeil(within(lowest.y())), 0));
  const cv::Point last(std::min(cvFloor(within(highest.x())), size - 1),
                       std::min(cvFloor(within(highest.y())), size - 1));
  if (first.x > last.x || first.y > last.y) return {};
  return {first, last + cv::Point(1, 1)};
}

cv::Rect texelsOf(const Corners& corners, int size) {
  constexpr float kNowhere = std::numeric_limits<float>::infinity();
  Eigen::Vector3f low = Eigen::Vector3f::Constant(kNowhere);
  Eigen::Vector3f high = -low;
  for (const Eigen::Vector3f& corner : corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  return texelsBetween(low, high, size);
}

/// One side of a triangle: not below 0 on the triangle's own side of it.
struct TexelSide {
  TexelSide(const Eigen::Vector3f& from, const Eigen::Vector3f& to)
      : along_column(from.y() - to.y()),
        along_row(to.x() - from.x()),
        constant(
            -(double{along_column} * double{from.x()} + double{along_row} * double{from.y()})) {}

  /// Where a row begins at this column; exact for the small triangles of bodies, so that no centre
  /// is beside both triangles of a side.
  [[nodiscard]] float at(int column, int row) const {
    return static_cast<float>(double{along_column} * column + double{along_row} * row + constant);
  }

  float along_column;
  float along_row;
  double constant;
};

/// The triangles' extent [texel] up to which whole numbers of 32 bits hold all that sides tell.
constexpr float kSmall = 32.0F;

/// The same of a small triangle, in squares of steps: exact, and sooner found.
class SmallSide {
 public:
  /// @param first  the texel that is looked at first; near the triangle
  SmallSide(const Eigen::Vector3f& from, const Eigen::Vector3f& to, const cv::Point& first) {
    const auto steps = [](float texels) { return static_cast<int>(texels * kTexelSteps); };
    constexpr int kTexel = static_cast<int>(kTexelSteps);
    const int column = steps(from.x() - static_cast<float>(first.x));
    const int row = steps(from.y() - static_cast<float>(first.y));
    const int along_column = steps(from.y() - to.y());
    const int along_row = steps(to.x() - from.x());
    at_ = -(along_column * column + along_row * row);
    along_column_ = along_column * kTexel;
    along_row_ = along_row * kTexel;
  }

  /// At the first texel and the three to the right of it.
  [[nodiscard]] cv::v_int32x4 begin() const {
    return cv::v_setall_s32(at_) +
           cv::v_int32x4(0, along_column_, 2 * along_column_, 3 * along_column_);
  }

  /// What is added for the next four texels of a row, and for those below.
  [[nodiscard]] cv::v_int32x4 nextFour() const {
    return cv::v_setall_s32(kLaneCount * along_column_);
  }
  [[nodiscard]] cv::v_int32x4 nextRow() const { return cv::v_setall_s32(along_row_); }

 private:
  int at_;
  int along_column_;
  int along_row_;
};

class PieceRaster {
 public:
  PieceRaster(MapPiece& piece, int size) : piece_(piece), size_(size) {}

  void draw(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
    const Eigen::Vector3f low = a.cwiseMin(b).cwiseMin(c);
    const Eigen::Vector3f high = a.cwiseMax(b).cwiseMax(c);
    const cv::Rect texels = texelsBetween(low, high, size_);
    if (texels.empty()) return;
    const Depths depths{a, slopeOf(a, b, c), std::clamp(low.z(), 0.0F, kFarthestDepth),
                        std::clamp(high.z(), 0.0F, kFarthestDepth)};
    if (high.x() - low.x() <= kSmall && high.y() - low.y() <= kSmall) {
      drawSmall(a, b, c, texels, depths);
    } else {
      drawLarge(a, b, c, texels, depths);
    }
  }

 private:
  /// The depths of a triangle's plane.
  struct Depths {
    const Eigen::Vector3f& corner;
    Eigen::Vector2f slope;  ///< a texel along columns and rows
    float nearest, farthest;

    [[nodiscard]] Lanes at(const cv::Point& first, int column) const {
      const float begin = corner.z() + slope.x() * (static_cast<float>(first.x) - corner.x()) +
                          slope.y() * (static_cast<float>(first.y) - corner.y());
      const Lanes steps = lanes(static_cast<float>(column)) + Lanes(0.0F, 1.0F, 2.0F, 3.0F);
      // Within the corners', whatever the slope of a sliver is.
      return clamped(lanes(begin) + lanes(slope.x()) * steps, nearest, farthest);
    }
  };

  void drawSmall(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c,
                 const cv::Rect& texels, const Depths& depths) {
    const SmallSide ab(a, b, texels.tl());
    const SmallSide bc(b, c, texels.tl());
    const SmallSide ca(c, a, texels.tl());
    cv::v_int32x4 row_ab = ab.begin();
    cv::v_int32x4 row_bc = bc.begin();
    cv::v_int32x4 row_ca = ca.begin();
    for (int row = texels.y; row < texels.y + texels.height; ++row) {
      cv::v_int32x4 of_ab = row_ab;
      cv::v_int32x4 of_bc = row_bc;
      cv::v_int32x4 of_ca = row_ca;
      for (int column = 0; column < texels.width; column += kLaneCount) {
        // The sign is set where it is beside one of them.
        const cv::v_int32x4 beside = of_ab | of_bc | of_ca;
        const Lanes covered = cv::v_reinterpret_as_f32(beside >= cv::v_setzero_s32());
        see(covered, depths.at({texels.x, row}, column), {texels.x + column, row});
        of_ab += ab.nextFour();
        of_bc += bc.nextFour();
        of_ca += ca.nextFour();
      }
      row_ab += ab.nextRow();
      row_bc += bc.nextRow();
      row_ca += ca.nextRow();
    }
  }

  void drawLarge(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c,
                 const cv::Rect& texels, const Depths& depths) {
    const std::array<TexelSide, 3> sides = {TexelSide(a, b), TexelSide(b, c), TexelSide(c, a)};
    const Lanes zero = lanes(0.0F);
    for (int row = texels.y; row < texels.y + texels.height; ++row) {
      std::array<float, 3> first{};
      for (std::size_t i = 0; i < 3; ++i) first[i] = sides[i].at(texels.x, row);
      const cv::Range columns = columnsWithin(sides, first, texels.width);
      for (int column = columns.start; column < columns.end; column += kLaneCount) {
        const Lanes steps = lanes(static_cast<float>(column)) + Lanes(0.0F, 1.0F, 2.0F, 3.0F);
        const Lanes covered = (lanes(first[0]) + lanes(sides[0].along_column) * steps >= zero) &
                              (lanes(first[1]) + lanes(sides[1].along_column) * steps >= zero) &
                              (lanes(first[2]) + lanes(sides[2].along_column) * steps >= zero);
        if (!cv::v_check_any(covered)) continue;
        see(covered, depths.at({texels.x, row}, column), {texels.x + column, row});
      }
    }
  }

  /// The columns of a row that may be within all sides, and a few more: from a whole number of
  /// lanes on.
  /// @param first  the sides' values at column 0
  static cv::Range columnsWithin(const std::array<TexelSide, 3>& sides,
                                 const std::array<float, 3>& first, int width) {
    constexpr float kRounding = 1.0F;  // [texel], and more than that of what the lanes find
    float begin = 0.0F;
    auto end = static_cast<float>(width);
    for (std::size_t i = 0; i < 3; ++i) {
      const float slope = sides[i].along_column;
      if (slope == 0.0F && first[i] < 0.0F) return {0, 0};
      const float edge = -first[i] / slope;
      if (slope > 0.0F) begin = std::max(begin, edge - kRounding);
      if (slope < 0.0F) end = std::min(end, edge + kRounding + 1.0F);
    }
    if (begin >= end) return {0, 0};
    return {static_cast<int>(begin) / kLaneCount * kLaneCount, static_cast<int>(std::ceil(end))};
  }

  /// Whole lanes: the piece has room for them behind its last column.
  void see(const Lanes& covered, const Lanes& depth, const cv::Point& texel) {
    float* at = piece_.depths.ptr<float>(texel.y - piece_.texels.y, texel.x - piece_.texels.x);
    const Lanes before = cv::v_load(at);
    cv::v_store(at, cv::v_select(covered, cv::v_min(depth, before), before));
  }

  /// The slope of the depth per texel along columns and rows.
  static Eigen::Vector2f slopeOf(const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                                 const Eigen::Vector3f& c) {
    const Eigen::Vector3f ab = b - a;
    const Eigen::Vector3f ac = c - a;
    const float area = ab.x() * ac.y() - ac.x() * ab.y();
    return {(ab.z() * ac.y() - ac.z() * ab.y()) / area, (ac.z() * ab.x() - ab.z() * ac.x()) / area};
  }

  MapPiece& piece_;
  int size_;
};

}  // namespace

std::optional<MapPiece> castPiece(const world::Mesh& mesh, const Eigen::Projective3f& map_from_mesh,
                                  int size, bool fronts_alone) {
  const Corners corners = cornersOf(mesh, map_from_mesh);
  MapPiece piece;
  piece.texels = texelsOf(corners, size);
  if (piece.texels.empty()) return std::nullopt;
  const cv::Mat roomy(piece.texels.height, piece.texels.width + kLaneCount, CV_32FC1,
                      cv::Scalar(kFarthestDepth));
  piece.depths = roomy.colRange(0, piece.texels.width);
  PieceRaster raster(piece, size);
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Eigen::Vector3f& a = corners[mesh.indices[i]];
    const Eigen::Vector3f& b = corners[mesh.indices[i + 1]];
    const Eigen::Vector3f& c = corners[mesh.indices[i + 2]];
    const Eigen::Vector2f ab = (b - a).head<2>();
    const Eigen::Vector2f ac = (c - a).head<2>();
    // Rows go up where light's frame has y go down: what faces the light turns left-handed.
    const float area = ab.x() * ac.y() - ac.x() * ab.y();
    if (area < 0.0F) raster.draw(a, c, b);
    if (area > 0.0F && !fronts_alone) raster.draw(a, b, c);
  }
  return piece;
}

}  // namespace synthetic_dataset::render
