#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core/fast_math.hpp>

#include "render/lens/lens_map.h"
#include "render/lens/ray_raster.h"
#include "render/lens/ray_side.h"
#include "render/parts/draw_list.h"
#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {

inline Eigen::Vector3d placeInCells(const Intrinsics& k, const Eigen::Vector3d& p_F) {
  return {k.fx * p_F.x() / p_F.z() + k.cx, k.fy * p_F.y() / p_F.z() + k.cy, 1.0 / p_F.z()};
}

/// A vertex of a mesh, seen from a face.
struct FaceCorner {
  Eigen::Vector3d point_F;
  Eigen::Vector2f place;  ///< [cell]; set only beyond the near plane
  float inverse_depth = 0.0F;
};

/// A triangle on a face, right-handed in the image.
struct FaceTriangle {
  const Eigen::Vector2f& p;
  const Eigen::Vector2f& q;
  const Eigen::Vector2f& r;

  [[nodiscard]] Eigen::Vector2f low() const { return p.cwiseMin(q).cwiseMin(r); }
  [[nodiscard]] Eigen::Vector2f high() const { return p.cwiseMax(q).cwiseMax(r); }
};

/// The rays of a grid, found by the cells in which they lie.
class CellRays {
 public:
  explicit CellRays(const RayGrid& grid) : grid_(grid) {}

  [[nodiscard]] const RayGrid& grid() const { return grid_; }

  /// Calls visit(first of four rays, their count) until all rays that the triangle may cover are
  /// visited.
  template <class Visit>
  void visit(const FaceTriangle& triangle, const Visit& visit) const {
    const Eigen::Vector2f low = triangle.low();
    const Eigen::Vector2f high = triangle.high();
    const int first_row = cellAt(low.y(), grid_.cells.height);
    const int last_row = cellAt(high.y(), grid_.cells.height);
    constexpr float kSlack = 0.01F;  // [cell]
    constexpr float kWide = 8.0F;    // [cell]
    const bool is_wide = high.x() - low.x() > kWide;
    for (int row = first_row; row <= last_row; ++row) {
      Span span{low.x(), high.x()};
      if (is_wide) {
        const float top = static_cast<float>(row) - kSlack;
        const float bottom = static_cast<float>(row + 1) + kSlack;
        span = {};
        span.add(triangle.p, triangle.q, top, bottom);
        span.add(triangle.q, triangle.r, top, bottom);
        span.add(triangle.r, triangle.p, top, bottom);
      }
      if (!(span.right + kSlack >= 0.0F) ||
          !(span.left - kSlack <= static_cast<float>(grid_.cells.width))) {
        continue;
      }
      const int from = row * grid_.cells.width + cellAt(span.left - kSlack, grid_.cells.width);
      const int to = row * grid_.cells.width + cellAt(span.right + kSlack, grid_.cells.width);
      const int end = grid_.first[static_cast<std::size_t>(to) + 1];
      for (int i = grid_.first[static_cast<std::size_t>(from)]; i < end; i += kLaneCount) {
        visit(static_cast<std::size_t>(i), kLaneCount);
      }
    }
  }

 private:
  /// The part of a row of cells that a triangle may cover.
  struct Span {
    float left = std::numeric_limits<float>::infinity();
    float right = -std::numeric_limits<float>::infinity();

    void add(const Eigen::Vector2f& from, const Eigen::Vector2f& to, float top, float bottom) {
      const bool goes_down = from.y() <= to.y();
      const Eigen::Vector2f& high = goes_down ? from : to;
      const Eigen::Vector2f& low = goes_down ? to : from;
      if (high.y() > bottom || low.y() < top) return;
      const float length = low.y() - high.y();
      const auto columnAt = [&](float row) {
        if (row <= high.y() || length <= 0.0F) return high.x();
        if (row >= low.y()) return low.x();
        return high.x() + (row - high.y()) / length * (low.x() - high.x());
      };
      const float first = columnAt(top);
      const float second = length > 0.0F ? columnAt(bottom) : low.x();
      left = std::min({left, first, second});
      right = std::max({right, first, second});
    }
  };

  static int cellAt(float place, int count) {
    return cvFloor(std::clamp(place, 0.0F, static_cast<float>(count - 1)));
  }

  const RayGrid& grid_;
};

/// Draws triangles of an item on a face, only at the places of some rays.
///
/// On which side of an edge a place lies is computed from the same corners in the same order for
/// both triangles that share the edge, so that no ray passes between them.
/// @tparam Rays  has grid() and visit() as CellRays does
template <class Rays>
class FaceDrawing {
 public:
  /// The references have to outlive this.
  FaceDrawing(const LensFace& face, const Rays& rays, const DrawItem& item,
              const RayRaster::IsHole& is_hole)
      : rays_(rays),
        grid_(rays.grid()),
        face_(face),
        item_(item),
        is_hole_(is_hole),
        near_(face.camera.near()),
        farthest_(static_cast<float>(1.0 / face.camera.far())) {
    if (!face.near_limit) return;
    reach_ = lanes(static_cast<float>(face.near_limit->reach));
    axis_ = lanes(Eigen::Vector3f(face.near_limit->axis_C.template cast<float>()));
    is_by_distance_ = face.near_limit->axis_C.isZero();
  }

  [[nodiscard]] FaceCorner cornerAt(const Eigen::Vector3d& point_F) const {
    if (!(point_F.z() >= near_)) return {point_F, {0.0F, 0.0F}, 0.0F};
    const Eigen::Vector3f place = placeInCells(grid_.intrinsics, point_F).cast<float>();
    return {point_F, place.head<2>(), place.z()};
  }

  /// Calls see(first of four rays, which of them, 1 / depth of each, *this) for the rays that meet
  /// the triangle.
  /// @param first  the position in Mesh::indices of the first of the triangle's three indices
  template <class See>
  void drawTriangle(std::uint32_t first, const FaceCorner& a, const FaceCorner& b,
                    const FaceCorner& c, See&& see) {
    const bool a_kept = a.point_F.z() >= near_;
    const bool b_kept = b.point_F.z() >= near_;
    const bool c_kept = c.point_F.z() >= near_;
    if (!a_kept && !b_kept && !c_kept) return;
    const bool is_whole = a_kept && b_kept && c_kept;
    if (is_whole && isBesideTheGrid(a, b, c)) return;
    const Eigen::Vector3d normal = (b.point_F - a.point_F).cross(c.point_F - a.point_F);
    const double offset = normal.dot(a.point_F);
    is_front_ = offset < 0.0;  // seen from outside, corners are in counter-clockwise order
    if (offset == 0.0 || (!is_front_ && !item_.double_sided)) return;
    first_ = first;
    corners_ = {&a, &b, &c};
    has_plane_ = false;
    normal_ = normal;
    offset_ = offset;
    if (is_whole) {
      nearest_ = std::max({a.inverse_depth, b.inverse_depth, c.inverse_depth});
      cover(a, b, c, see);
    } else {
      nearest_ = static_cast<float>(1.0 / near_);
      drawClipped(see);
    }
  }

  [[nodiscard]] std::uint32_t first() const { return first_; }
  [[nodiscard]] bool isFront() const { return is_front_; }

  /// Whether the triangle has a hole where a ray meets it.
  [[nodiscard]] bool isHole(std::size_t ray) const {
    const auto& indices = item_.shape->indices;
    return is_hole_(item_, {{corners_[0]->point_F.cast<float>(), corners_[1]->point_F.cast<float>(),
                             corners_[2]->point_F.cast<float>()},
                            {indices[first_], indices[first_ + 1], indices[first_ + 2]},
                            grid_.intrinsics,
                            grid_.columns[ray],
                            grid_.rows[ray]});
  }

 private:
  /// A triangle's plane, as 1 / depth, which is linear over the face.
  struct Plane {
    float column, row, inverse_depth;  ///< at its farthest corner
    float slope_column, slope_row;     ///< of 1 / depth
    float nearest;                     ///< 1 / depth of its nearest corner
  };

  [[nodiscard]] bool isBesideTheGrid(const FaceCorner& a, const FaceCorner& b,
                                     const FaceCorner& c) const {
    const Eigen::Vector2f low = a.place.cwiseMin(b.place).cwiseMin(c.place);
    const Eigen::Vector2f high = a.place.cwiseMax(b.place).cwiseMax(c.place);
    return high.x() < 0.0F || high.y() < 0.0F || low.x() > static_cast<float>(grid_.cells.width) ||
           low.y() > static_cast<float>(grid_.cells.height);
  }

  /// Draws the part of a triangle beyond the near plane.
  template <class See>
  void drawClipped(See&& see) {
    std::array<FaceCorner, 4> kept;
    std::size_t count = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const FaceCorner& from = *corners_[i];
      const FaceCorner& to = *corners_[(i + 1) % corners_.size()];
      const bool from_kept = from.point_F.z() >= near_;
      if (from_kept) kept[count++] = from;
      if (from_kept != (to.point_F.z() >= near_)) {
        kept[count++] = from_kept ? cut(from, to) : cut(to, from);
      }
    }
    for (std::size_t i = 2; i < count; ++i) cover(kept[0], kept[i - 1], kept[i], see);
  }

  /// The point where a side meets the near plane, the same for both triangles that share the side.
  [[nodiscard]] FaceCorner cut(const FaceCorner& kept, const FaceCorner& lost) const {
    const double share = (near_ - kept.point_F.z()) / (lost.point_F.z() - kept.point_F.z());
    Eigen::Vector3d point = kept.point_F + share * (lost.point_F - kept.point_F);
    point.z() = near_;
    return cornerAt(point);
  }

  template <class See>
  void cover(const FaceCorner& a, const FaceCorner& second, const FaceCorner& third, See&& see) {
    const FaceTriangle triangle{a.place, is_front_ ? third.place : second.place,
                                is_front_ ? second.place : third.place};
    const RaySide one(triangle.p, triangle.q);
    const RaySide two(triangle.q, triangle.r);
    const RaySide three(triangle.r, triangle.p);
    rays_.visit(triangle, [&](std::size_t at, int count) {
      const Lanes u = cv::v_load(&grid_.columns[at]);
      const Lanes v = cv::v_load(&grid_.rows[at]);
      Lanes covered = one.inside(u, v) & two.inside(u, v) & three.inside(u, v);
      if (count < kLaneCount) {
        covered = covered & (Lanes(0.0F, 1.0F, 2.0F, 3.0F) < lanes(static_cast<float>(count)));
      }
      if (cv::v_check_any(covered)) found(at, covered, u, v, see);
    });
  }

  template <class See>
  void found(std::size_t at, Lanes covered, const Lanes& u, const Lanes& v, See&& see) {
    if (!has_plane_) makePlane();
    const Lanes on_plane = lanes(plane_.inverse_depth) +
                           lanes(plane_.slope_column) * (u - lanes(plane_.column)) +
                           lanes(plane_.slope_row) * (v - lanes(plane_.row));
    // Between those of the corners, however steep a sliver is.
    const Lanes inverse_depth = clamped(on_plane, plane_.inverse_depth, plane_.nearest);
    covered = covered & (inverse_depth >= lanes(farthest_));
    if (face_.near_limit) {
      covered = covered & (inverse_depth * reach_ <= reachOfUnitDepth(u, v));
    }
    see(at, covered, inverse_depth, *this);
  }

  void makePlane() {
    const Intrinsics& k = grid_.intrinsics;
    const FaceCorner& far = **std::min_element(corners_.begin(), corners_.end(),
                                               [](const FaceCorner* one, const FaceCorner* other) {
                                                 return one->point_F.z() > other->point_F.z();
                                               });
    plane_ = {far.place.x(),
              far.place.y(),
              far.inverse_depth,
              static_cast<float>(normal_.x() / (k.fx * offset_)),
              static_cast<float>(normal_.y() / (k.fy * offset_)),
              nearest_};
    has_plane_ = true;
  }

  /// How far points at a depth of 1 m are, measured as NearLimit::reach is.
  [[nodiscard]] Lanes reachOfUnitDepth(const Lanes& u, const Lanes& v) const {
    const Intrinsics& k = grid_.intrinsics;
    const Lanes3 ray{(u - lanes(static_cast<float>(k.cx))) * lanes(static_cast<float>(1.0 / k.fx)),
                     (v - lanes(static_cast<float>(k.cy))) * lanes(static_cast<float>(1.0 / k.fy)),
                     lanes(1.0F)};
    return is_by_distance_ ? length(ray) : dot(ray, axis_);
  }

  const Rays& rays_;
  const RayGrid& grid_;
  const LensFace& face_;
  const DrawItem& item_;
  const RayRaster::IsHole& is_hole_;
  double near_;
  float farthest_;
  Lanes reach_ = lanes(0.0F);
  Lanes3 axis_ = lanes(0.0F, 0.0F, 0.0F);
  bool is_by_distance_ = false;

  // The triangle that is drawn.
  std::uint32_t first_ = 0;
  bool is_front_ = true;
  std::array<const FaceCorner*, 3> corners_ = {};
  Eigen::Vector3d normal_;
  double offset_ = 0.0;
  float nearest_ = 0.0F;
  bool has_plane_ = false;
  Plane plane_{};
};

/// Records what is drawn as what the rays see. Of coincident surfaces, the last one that stands
/// still is seen; a moving one never hides one that stands still.
class SightRecorder {
 public:
  SightRecorder(const DrawItem& item, int number, std::size_t face, RaySights& sights)
      : has_holes_(item.has_holes),
        number_(number),
        least_(lanes(item.stands_still ? 1.0F - kSameDepth : 1.0F + kSameDepth)),
        depths_(sights.inverse_depths[face]),
        triangles_(sights.triangles[face]),
        seen_(sights.seen) {}

  /// Begins a series of triangles.
  /// @param row  as in SeenTriangle
  void beginTriangles(int row) {
    row_ = row;
    last_ = std::numeric_limits<std::uint32_t>::max();
  }

  template <class Drawing>
  void operator()(std::size_t at, const Lanes& covered, const Lanes& inverse_depth,
                  const Drawing& here) {
    const Lanes before = cv::v_load(&depths_[at]);
    const Lanes nearer = covered & (inverse_depth >= before * least_);
    int bits = cv::v_signmask(nearer);
    if (bits == 0) return;
    if (has_holes_) {
      for (std::size_t i = 0; i < kLaneCount; ++i) {
        if ((bits >> i & 1) != 0 && here.isHole(at + i)) bits &= ~(1 << i);
      }
    }
    if (last_ != here.first()) {
      last_ = here.first();
      seen_.push_back({number_, here.first(), here.isFront(), row_});
    }
    std::array<float, kLaneCount> found;
    cv::v_store(found.data(), inverse_depth);
    for (std::size_t i = 0; i < kLaneCount; ++i) {
      if ((bits >> i & 1) == 0) continue;
      depths_[at + i] = found[i];
      triangles_[at + i] = static_cast<int>(seen_.size()) - 1;
    }
  }

 private:
  /// Surfaces whose depths differ by a smaller share than this coincide: which item is seen there
  /// depends on their order.
  static constexpr float kSameDepth = 1e-5F;

  bool has_holes_;
  int number_;
  Lanes least_;
  std::vector<float>& depths_;
  std::vector<int>& triangles_;
  std::vector<SeenTriangle>& seen_;
  int row_ = -1;
  std::uint32_t last_ = std::numeric_limits<std::uint32_t>::max();
};

}  // namespace synthetic_dataset::render
