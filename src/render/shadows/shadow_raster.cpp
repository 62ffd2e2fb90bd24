#include "render/shadows/shadow_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <opencv2/core/fast_math.hpp>
#include <opencv2/core/utility.hpp>

#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {
namespace {

constexpr float kFarthestDepth = 1.0F;
constexpr float kTexelSteps = 256.0F;  // per texel, to which corners are rounded

/// Corners in the map: column and row, with texels' centres at integers; and depth.
using Corners = std::vector<Eigen::Vector3f>;

/// Rounds to the nearest step, halves away from 0.
float rounded(float texels) {
  const float steps = texels * kTexelSteps;
  // Beyond this, all single-precision numbers are integers.
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

/// Those of some texels whose centres are between two places.
cv::Rect texelsBetween(const Eigen::Vector3f& lowest, const Eigen::Vector3f& highest,
                       const cv::Rect& texels) {
  const cv::Point end = texels.br();
  const auto first = [](float place, int begin, int stop) {
    return cvCeil(std::min(std::max(place, static_cast<float>(begin)), static_cast<float>(stop)));
  };
  const auto last = [](float place, int begin, int stop) {
    return cvFloor(
        std::min(std::max(place, static_cast<float>(begin - 1)), static_cast<float>(stop - 1)));
  };
  const cv::Point low(first(lowest.x(), texels.x, end.x), first(lowest.y(), texels.y, end.y));
  const cv::Point high(last(highest.x(), texels.x, end.x), last(highest.y(), texels.y, end.y));
  if (low.x > high.x || low.y > high.y) return {};
  return {low, high + cv::Point(1, 1)};
}

cv::Rect texelsOf(const Corners& corners, int size) {
  constexpr float kNowhere = std::numeric_limits<float>::infinity();
  Eigen::Vector3f low = Eigen::Vector3f::Constant(kNowhere);
  Eigen::Vector3f high = -low;
  for (const Eigen::Vector3f& corner : corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  return texelsBetween(low, high, {0, 0, size, size});
}

/// The edge function of one side of a triangle, which is not below 0 on the triangle's own side. As
/// corners are rounded, it is exact: no centre is outside both triangles that share a side.
class TexelSide {
 public:
  TexelSide(const Eigen::Vector3f& from, const Eigen::Vector3f& to, int first_row)
      : along_column_(double{from.y()} - double{to.y()}),
        along_row_(double{to.x()} - double{from.x()}),
        columns_(along_column_ == 0.0 ? 0.0 : -1.0 / along_column_),
        at_column_0_(along_row_ * (first_row - double{from.y()}) -
                     along_column_ * double{from.x()}) {}

  void nextRow() { at_column_0_ += along_row_; }

  /// Narrows the range of the row's columns to those that are on the triangle's side.
  void narrow(int& first, int& end) const {
    const double edge = std::clamp(at_column_0_ * columns_, first - 1.0, end + 1.0);
    // The quotient is rounded, so the column may be off by one.
    const int nearest = static_cast<int>(edge);
    const double there = along_column_ * nearest + at_column_0_;
    if (along_column_ > 0.0) {
      const int begin = there < 0.0 ? nearest + 1 : there < along_column_ ? nearest : nearest - 1;
      first = std::max(first, begin);
    } else if (along_column_ < 0.0) {
      const int last = there < 0.0 ? nearest - 1 : there < -along_column_ ? nearest : nearest + 1;
      end = std::min(end, last + 1);
    } else if (at_column_0_ < 0.0) {
      end = first;
    }
  }

 private:
  double along_column_;
  double along_row_;
  double columns_;      ///< factor from a value at column 0 to the column where it is 0
  double at_column_0_;  ///< the value at column 0 of the row
};

/// The extent of triangles [texel] up to which 32-bit integers can hold all edge functions' values.
constexpr float kSmall = 32.0F;

/// The edge function of a side of a small triangle, in squared steps: exact, and faster.
class SmallSide {
 public:
  /// @param first  the texel that is examined first; near the triangle
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

  /// The values at the first texel and the three to the right of it.
  [[nodiscard]] cv::v_int32x4 begin() const {
    return cv::v_setall_s32(at_) +
           cv::v_int32x4(0, along_column_, 2 * along_column_, 3 * along_column_);
  }

  /// The increments to the next four texels of a row, and to those in the next row.
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
  /// @param piece  has room for kLaneCount texels behind each row
  explicit PieceRaster(MapPiece& piece) : piece_(piece) {}

  void draw(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
    const Eigen::Vector3f low = a.cwiseMin(b).cwiseMin(c);
    const Eigen::Vector3f high = a.cwiseMax(b).cwiseMax(c);
    const cv::Rect texels = texelsBetween(low, high, piece_.texels);
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
    Eigen::Vector2f slope;  ///< per texel along columns and rows
    float nearest, farthest;

    [[nodiscard]] float begin(const cv::Point& first) const {
      return corner.z() + slope.x() * (static_cast<float>(first.x) - corner.x()) +
             slope.y() * (static_cast<float>(first.y) - corner.y());
    }

    /// @param begin  the depth at some texel
    /// @param column  counted from that texel
    [[nodiscard]] Lanes at(float begin, int column) const {
      const Lanes steps = lanes(static_cast<float>(column)) + Lanes(0.0F, 1.0F, 2.0F, 3.0F);
      // Between those of the corners, however steep a sliver is.
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
      const float begin = depths.begin({texels.x, row});
      float* to = texel({texels.x, row});
      for (int column = 0; column < texels.width; column += kLaneCount) {
        // The sign bit is set where a texel is outside one of the sides.
        const cv::v_int32x4 beside = of_ab | of_bc | of_ca;
        const Lanes covered = cv::v_reinterpret_as_f32(beside >= cv::v_setzero_s32());
        see(covered, depths.at(begin, column), to + column);
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
    std::array<TexelSide, 3> sides = {TexelSide(a, b, texels.y), TexelSide(b, c, texels.y),
                                      TexelSide(c, a, texels.y)};
    for (int row = texels.y; row < texels.y + texels.height; ++row) {
      int first = texels.x;
      int end = texels.x + texels.width;
      for (TexelSide& side : sides) {
        side.narrow(first, end);
        side.nextRow();
      }
      if (first >= end) continue;
      const float begin = depths.begin({texels.x, row});
      float* to = texel({texels.x, row});
      for (int column = first - texels.x; column < end - texels.x; column += kLaneCount) {
        const cv::v_int32x4 here = cv::v_setall_s32(column) + cv::v_int32x4(0, 1, 2, 3);
        const cv::v_int32x4 is_before = here < cv::v_setall_s32(end - texels.x);
        see(cv::v_reinterpret_as_f32(is_before), depths.at(begin, column), to + column);
      }
    }
  }

  [[nodiscard]] float* texel(const cv::Point& at) {
    return piece_.depths.ptr<float>(at.y - piece_.texels.y, at.x - piece_.texels.x);
  }

  /// Stores all four lanes, as the piece has room for them behind its last column.
  static void see(const Lanes& covered, const Lanes& depth, float* at) {
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
};

void drawTriangles(const CastBody& body, const Corners& corners, PieceRaster& raster) {
  const std::vector<std::uint32_t>& indices = body.mesh->indices;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const Eigen::Vector3f& a = corners[indices[i]];
    const Eigen::Vector3f& b = corners[indices[i + 1]];
    const Eigen::Vector3f& c = corners[indices[i + 2]];
    const Eigen::Vector2f ab = (b - a).head<2>();
    const Eigen::Vector2f ac = (c - a).head<2>();
    // Rows increase with the y axis of the light's frame: triangles that face the light have a
    // negative area.
    const float area = ab.x() * ac.y() - ac.x() * ab.y();
    if (area < 0.0F) raster.draw(a, c, b);
    if (area > 0.0F && !body.fronts_only) raster.draw(a, b, c);
  }
}

/// A piece with the farthest depth everywhere, and with room for lanes behind each row.
MapPiece emptyPiece(const cv::Rect& texels) {
  cv::Mat roomy(texels.height, texels.width + kLaneCount, CV_32FC1);
  std::fill_n(roomy.ptr<float>(), roomy.total(), kFarthestDepth);
  return {texels, roomy.colRange(0, texels.width)};
}

}  // namespace

std::optional<MapPiece> castPiece(const CastBody& body, int size) {
  const Corners corners = cornersOf(*body.mesh, body.map_from_mesh);
  const cv::Rect texels = texelsOf(corners, size);
  if (texels.empty()) return std::nullopt;
  MapPiece piece = emptyPiece(texels);
  PieceRaster raster(piece);
  drawTriangles(body, corners, raster);
  return piece;
}

cv::Mat castMap(const std::vector<CastBody>& bodies, int size) {
  struct Placed {
    Corners corners;
    cv::Rect texels;
  };
  std::vector<Placed> placed(bodies.size());
  cv::parallel_for_(cv::Range(0, static_cast<int>(bodies.size())), [&](const cv::Range& some) {
    for (auto i = static_cast<std::size_t>(some.start); i < static_cast<std::size_t>(some.end);
         ++i) {
      placed[i].corners = cornersOf(*bodies[i].mesh, bodies[i].map_from_mesh);
      placed[i].texels = texelsOf(placed[i].corners, size);
    }
  });
  cv::Mat roomy(size, size + kLaneCount, CV_32FC1);
  cv::Mat map = roomy.colRange(0, size);
  constexpr int kBand = 128;  // [texel], a band's height
  const int bands = (size + kBand - 1) / kBand;
  cv::parallel_for_(
      cv::Range(0, bands),
      [&](const cv::Range& some) {
        const cv::Rect texels =
            cv::Rect(0, kBand * some.start, size, kBand * some.size()) & cv::Rect(0, 0, size, size);
        MapPiece band{texels, map(texels)};
        std::fill_n(roomy.ptr<float>(texels.y),
                    roomy.step1() * static_cast<std::size_t>(texels.height), kFarthestDepth);
        PieceRaster raster(band);
        for (std::size_t i = 0; i < bodies.size(); ++i) {
          if ((placed[i].texels & texels).empty()) continue;
          drawTriangles(bodies[i], placed[i].corners, raster);
        }
      },
      bands);
  return map;
}

}  // namespace synthetic_dataset::render
