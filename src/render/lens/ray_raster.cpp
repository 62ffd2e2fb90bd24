#include "render/lens/ray_raster.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <Eigen/Geometry>
#include <opencv2/core/fast_math.hpp>

#include "render/lens/ray_side.h"
#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {
namespace {

/// Depths that differ by less are of the same place: which part is seen there is a matter of order.
constexpr float kSameDepth = 1e-5F;

Eigen::Vector3d placeInCells(const Intrinsics& k, const Eigen::Vector3d& p_F) {
  return {k.fx * p_F.x() / p_F.z() + k.cx, k.fy * p_F.y() / p_F.z() + k.cy, 1.0 / p_F.z()};
}

}  // namespace

RaySights::RaySights(const std::vector<RayGrid>& grids) {
  for (const RayGrid& grid : grids) {
    inverse_depths.emplace_back(grid.count() + RayGrid::kSpare, 0.0F);
    triangles.emplace_back(grid.count() + RayGrid::kSpare, -1);
  }
}

/// A vertex of the mesh.
struct RayRaster::Corner {
  Eigen::Vector3d point_F;
  Eigen::Vector2f place;  ///< [cell]; of those that are not nearer than the near plane
  float inverse_depth = 0.0F;
};

/// Of a triangle: 1 / depth is linear over its face.
struct RayRaster::Plane {
  float column, row, inverse_depth;  ///< at its farthest corner
  float slope_column, slope_row;     ///< of 1 / depth
  float nearest;                     ///< 1 / depth of its nearest corner
};

/// Draws the triangles of a part on a face.
class RayRaster::OnFace {
 public:
  OnFace(const RayRaster& raster, std::size_t face, const Part& part, const Pose& X_WL)
      : grid_(raster.grids_[face]),
        face_(raster.lens_.faces[face]),
        part_(part),
        is_hole_(raster.is_hole_),
        X_FV_((raster.view_.X_WC * face_.X_CF).inverse() * X_WL * part.X_LV),
        near_(face_.camera.near()),
        farthest_(static_cast<float>(1.0 / face_.camera.far())) {
    if (!face_.near_limit) return;
    reach_ = lanes(static_cast<float>(face_.near_limit->reach));
    axis_ = lanes(Eigen::Vector3f(face_.near_limit->axis_C.cast<float>()));
    is_by_distance_ = face_.near_limit->axis_C.isZero();
  }

  /// Whether some of the part's bounds may be on the face.
  [[nodiscard]] bool mayBeSeen() const {
    if (part_.bounds_V.isEmpty()) return false;
    const Intrinsics& k = grid_.intrinsics;
    // Beside which planes through the camera's centre all corners are.
    std::array<bool, 5> beside = {true, true, true, true, true};
    Eigen::AlignedBox2d box;
    bool is_ahead = true;
    for (const Eigen::Vector3d& corner : cornersOf(part_.bounds_V)) {
      const Eigen::Vector3d p = X_FV_ * corner;
      const double column = k.fx * p.x() + k.cx * p.z();
      const double row = k.fy * p.y() + k.cy * p.z();
      beside[0] &= p.z() < near_;
      beside[1] &= column < 0.0;
      beside[2] &= row < 0.0;
      beside[3] &= column > grid_.cells.width * p.z();
      beside[4] &= row > grid_.cells.height * p.z();
      is_ahead = is_ahead && p.z() >= near_;
      if (is_ahead) box.extend(Eigen::Vector2d(column / p.z(), row / p.z()));
    }
    if (std::any_of(beside.begin(), beside.end(), [](bool each) { return each; })) return false;
    return !is_ahead || hasRaysIn(box);
  }

  /// Calls see(first of four rays, which of them, 1 / depth of each, first index, is front).
  template <class See>
  void draw(const See& see) {
    const world::Mesh& mesh = *part_.shape;
    std::vector<Corner> corners;
    corners.reserve(mesh.positions.size());
    for (const Eigen::Vector3f& position : mesh.positions) {
      corners.push_back(cornerAt(X_FV_ * position.cast<double>()));
    }
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      drawTriangle(static_cast<std::uint32_t>(i), corners[mesh.indices[i]],
                   corners[mesh.indices[i + 1]], corners[mesh.indices[i + 2]], see);
    }
  }

 private:
  [[nodiscard]] bool hasRaysIn(const Eigen::AlignedBox2d& box) const {
    constexpr double kSlack = 0.01;  // [cell]
    const auto cell = [](double place, int count) {
      return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(count - 1)));
    };
    const int left = cell(box.min().x() - kSlack, grid_.cells.width);
    const int right = cell(box.max().x() + kSlack, grid_.cells.width);
    const int bottom = cell(box.max().y() + kSlack, grid_.cells.height);
    for (int row = cell(box.min().y() - kSlack, grid_.cells.height); row <= bottom; ++row) {
      const auto first = static_cast<std::size_t>(row * grid_.cells.width);
      if (grid_.first[first + static_cast<std::size_t>(right) + 1] >
          grid_.first[first + static_cast<std::size_t>(left)]) {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] Corner cornerAt(const Eigen::Vector3d& point_F) const {
    if (!(point_F.z() >= near_)) return {point_F, {0.0F, 0.0F}, 0.0F};
    const Eigen::Vector3f place = placeInCells(grid_.intrinsics, point_F).cast<float>();
    return {point_F, place.head<2>(), place.z()};
  }

  template <class See>
  void drawTriangle(std::uint32_t first, const Corner& a, const Corner& b, const Corner& c,
                    const See& see) {
    const bool a_kept = a.point_F.z() >= near_;
    const bool b_kept = b.point_F.z() >= near_;
    const bool c_kept = c.point_F.z() >= near_;
    if (!a_kept && !b_kept && !c_kept) return;
    const bool is_whole = a_kept && b_kept && c_kept;
    if (is_whole && isBesideTheGrid(a, b, c)) return;
    const Eigen::Vector3d normal = (b.point_F - a.point_F).cross(c.point_F - a.point_F);
    const double offset = normal.dot(a.point_F);
    is_front_ = offset < 0.0;  // from outside, corners go round counter-clockwise
    if (offset == 0.0 || (!is_front_ && !part_.double_sided)) return;
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

  [[nodiscard]] bool isBesideTheGrid(const Corner& a, const Corner& b, const Corner& c) const {
    const Eigen::Vector2f low = a.place.cwiseMin(b.place).cwiseMin(c.place);
    const Eigen::Vector2f high = a.place.cwiseMax(b.place).cwiseMax(c.place);
    return high.x() < 0.0F || high.y() < 0.0F || low.x() > static_cast<float>(grid_.cells.width) ||
           low.y() > static_cast<float>(grid_.cells.height);
  }

  /// What of a triangle is not nearer than the near plane.
  template <class See>
  void drawClipped(const See& see) {
    std::array<Corner, 4> kept;
    std::size_t count = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Corner& from = *corners_[i];
      const Corner& to = *corners_[(i + 1) % corners_.size()];
      const bool from_kept = from.point_F.z() >= near_;
      if (from_kept) kept[count++] = from;
      if (from_kept != (to.point_F.z() >= near_)) {
        kept[count++] = from_kept ? cut(from, to) : cut(to, from);
      }
    }
    for (std::size_t i = 2; i < count; ++i) cover(kept[0], kept[i - 1], kept[i], see);
  }

  /// Where a side meets the near plane: the same for both triangles that share it.
  [[nodiscard]] Corner cut(const Corner& kept, const Corner& lost) const {
    const double share = (near_ - kept.point_F.z()) / (lost.point_F.z() - kept.point_F.z());
    Eigen::Vector3d point = kept.point_F + share * (lost.point_F - kept.point_F);
    point.z() = near_;
    return cornerAt(point);
  }

  /// Of a triangle, what of a row of cells it may cover [cell].
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

  template <class See>
  void cover(const Corner& a, const Corner& second, const Corner& third, const See& see) {
    const Eigen::Vector2f& p = a.place;
    const Eigen::Vector2f& q = is_front_ ? third.place : second.place;
    const Eigen::Vector2f& r = is_front_ ? second.place : third.place;
    const RaySide one(p, q);
    const RaySide two(q, r);
    const RaySide three(r, p);
    const Eigen::Vector2f low = p.cwiseMin(q).cwiseMin(r);
    const Eigen::Vector2f high = p.cwiseMax(q).cwiseMax(r);
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
        span.add(p, q, top, bottom);
        span.add(q, r, top, bottom);
        span.add(r, p, top, bottom);
      }
      if (!(span.right + kSlack >= 0.0F) ||
          !(span.left - kSlack <= static_cast<float>(grid_.cells.width))) {
        continue;
      }
      const int from = row * grid_.cells.width + cellAt(span.left - kSlack, grid_.cells.width);
      const int to = row * grid_.cells.width + cellAt(span.right + kSlack, grid_.cells.width);
      const int end = grid_.first[static_cast<std::size_t>(to) + 1];
      for (int i = grid_.first[static_cast<std::size_t>(from)]; i < end; i += kLaneCount) {
        const auto at = static_cast<std::size_t>(i);
        const Lanes u = cv::v_load(&grid_.columns[at]);
        const Lanes v = cv::v_load(&grid_.rows[at]);
        const Lanes covered = one.inside(u, v) & two.inside(u, v) & three.inside(u, v);
        if (cv::v_check_any(covered)) found(at, covered, u, v, see);
      }
    }
  }

  static int cellAt(float place, int count) {
    return cvFloor(std::clamp(place, 0.0F, static_cast<float>(count - 1)));
  }

  template <class See>
  void found(std::size_t at, Lanes covered, const Lanes& u, const Lanes& v, const See& see) {
    if (!has_plane_) makePlane();
    const Lanes on_plane = lanes(plane_.inverse_depth) +
                           lanes(plane_.slope_column) * (u - lanes(plane_.column)) +
                           lanes(plane_.slope_row) * (v - lanes(plane_.row));
    // Within the corners', whatever the slope of a sliver is.
    const Lanes inverse_depth = clamped(on_plane, plane_.inverse_depth, plane_.nearest);
    covered = covered & (inverse_depth >= lanes(farthest_));
    if (face_.near_limit) {
      covered = covered & (inverse_depth * reach_ <= reachOfUnitDepth(u, v));
    }
    see(at, covered, inverse_depth, *this);
  }

  void makePlane() {
    const Intrinsics& k = grid_.intrinsics;
    const Corner& far = **std::min_element(corners_.begin(), corners_.end(),
                                           [](const Corner* one, const Corner* other) {
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

  /// How far what lies at a depth of 1 m reaches, as the limit counts.
  [[nodiscard]] Lanes reachOfUnitDepth(const Lanes& u, const Lanes& v) const {
    const Intrinsics& k = grid_.intrinsics;
    const Lanes3 ray{(u - lanes(static_cast<float>(k.cx))) * lanes(static_cast<float>(1.0 / k.fx)),
                     (v - lanes(static_cast<float>(k.cy))) * lanes(static_cast<float>(1.0 / k.fy)),
                     lanes(1.0F)};
    return is_by_distance_ ? length(ray) : dot(ray, axis_);
  }

 public:
  [[nodiscard]] std::uint32_t first() const { return first_; }
  [[nodiscard]] bool isFront() const { return is_front_; }

  /// Whether the triangle has a hole where a ray meets it.
  [[nodiscard]] bool isHole(std::size_t ray) const {
    const auto& indices = part_.shape->indices;
    return is_hole_(part_, {{corners_[0]->point_F.cast<float>(), corners_[1]->point_F.cast<float>(),
                             corners_[2]->point_F.cast<float>()},
                            {indices[first_], indices[first_ + 1], indices[first_ + 2]},
                            grid_.intrinsics,
                            grid_.columns[ray],
                            grid_.rows[ray]});
  }

 private:
  const RayGrid& grid_;
  const LensFace& face_;
  const Part& part_;
  const IsHole& is_hole_;
  Pose X_FV_;
  double near_;
  float farthest_;
  Lanes reach_ = lanes(0.0F);
  Lanes3 axis_ = lanes(0.0F, 0.0F, 0.0F);
  bool is_by_distance_ = false;

  // Of the triangle that is drawn.
  std::uint32_t first_ = 0;
  bool is_front_ = true;
  std::array<const Corner*, 3> corners_ = {};
  Eigen::Vector3d normal_;
  double offset_ = 0.0;
  float nearest_ = 0.0F;
  bool has_plane_ = false;
  Plane plane_{};
};

void RayRaster::draw(const Part& part, int number, const Pose& X_WL, RaySights& sights) const {
  const Lanes least = lanes(part.stands_still ? 1.0F - kSameDepth : 1.0F + kSameDepth);
  for (std::size_t face = 0; face < grids_.size(); ++face) {
    OnFace drawing(*this, face, part, X_WL);
    if (!drawing.mayBeSeen()) continue;
    std::vector<float>& depths = sights.inverse_depths[face];
    std::vector<int>& triangles = sights.triangles[face];
    std::uint32_t last = std::numeric_limits<std::uint32_t>::max();
    drawing.draw(
        [&](std::size_t at, const Lanes& covered, const Lanes& inverse_depth, const OnFace& here) {
          const Lanes before = cv::v_load(&depths[at]);
          const Lanes nearer = covered & (inverse_depth >= before * least);
          int bits = cv::v_signmask(nearer);
          if (bits == 0) return;
          if (part.has_holes) {
            for (std::size_t i = 0; i < kLaneCount; ++i) {
              if ((bits >> i & 1) != 0 && here.isHole(at + i)) bits &= ~(1 << i);
            }
          }
          if (last != here.first()) {
            last = here.first();
            sights.seen.push_back({number, here.first(), here.isFront()});
          }
          std::array<float, kLaneCount> found;
          cv::v_store(found.data(), inverse_depth);
          for (std::size_t i = 0; i < kLaneCount; ++i) {
            if ((bits >> i & 1) == 0) continue;
            depths[at + i] = found[i];
            triangles[at + i] = static_cast<int>(sights.seen.size()) - 1;
          }
        });
  }
}

void RayRaster::visitCovered(const Part& part, const Pose& X_WL,
                             const std::function<void(int ray)>& visit) const {
  for (std::size_t face = 0; face < grids_.size(); ++face) {
    OnFace drawing(*this, face, part, X_WL);
    if (!drawing.mayBeSeen()) continue;
    const std::vector<int>& rays = grids_[face].rays;
    drawing.draw([&](std::size_t at, const Lanes& covered, const Lanes&, const OnFace& here) {
      const int bits = cv::v_signmask(covered);
      for (std::size_t i = 0; i < kLaneCount; ++i) {
        if ((bits >> i & 1) == 0 || (part.has_holes && here.isHole(at + i))) continue;
        visit(rays[at + i]);
      }
    });
  }
}

}  // namespace synthetic_dataset::render
