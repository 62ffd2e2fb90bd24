#include "render/lens/row_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <Eigen/Geometry>

#include "render/lens/face_drawing.h"

namespace synthetic_dataset::render {
namespace {

/// The rays of one row.
class RowRays {
 public:
  explicit RowRays(const RayGrid& grid) : grid_(grid) {}

  void goTo(int row) { row_ = static_cast<std::size_t>(row); }

  [[nodiscard]] const RayGrid& grid() const { return grid_; }

  /// Calls visit(first of four rays, how many of them) until all rays that the triangle may cover
  /// are visited.
  template <class Visit>
  void visit(const FaceTriangle& triangle, const Visit& visit) const {
    const auto begin = grid_.columns.begin();
    const auto end = begin + grid_.first[row_ + 1];
    const auto first = std::lower_bound(begin + grid_.first[row_], end, triangle.low().x());
    const auto last = std::upper_bound(first, end, triangle.high().x());
    for (auto at = first; at < last; at += kLaneCount) {
      visit(static_cast<std::size_t>(at - begin),
            static_cast<int>(std::min<std::ptrdiff_t>(last - at, kLaneCount)));
      if (last - at < kLaneCount) break;
    }
  }

 private:
  const RayGrid& grid_;
  std::size_t row_ = 0;
};

/// Passes on the rays that an item covers.
struct CoveredRays {
  const std::vector<int>& rays;
  bool has_holes;
  const std::function<void(int ray)>& visit;

  void beginTriangles(int /*row*/) {}

  void operator()(std::size_t at, const Lanes& covered, const Lanes& /*inverse_depth*/,
                  const FaceDrawing<RowRays>& here) const {
    const int bits = cv::v_signmask(covered);
    for (std::size_t i = 0; i < kLaneCount; ++i) {
      if ((bits >> i & 1) == 0 || (has_holes && here.isHole(at + i))) continue;
      visit(rays[at + i]);
    }
  }
};

/// The farthest that points within some bounds get, at any of the poses, from the straight line
/// between where they are at the first and at the last pose.
double farthestFromLine(const Bounds& bounds, const std::vector<Pose>& poses) {
  const Eigen::Vector3d middle = bounds.center();
  const double radius = 0.5 * bounds.sizes().norm();
  const Eigen::Matrix4d first = poses.front().matrix();
  const Eigen::Matrix4d change = poses.back().matrix() - first;
  double farthest = 0.0;
  for (std::size_t i = 1; i + 1 < poses.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(poses.size() - 1);
    const Eigen::Matrix4d off = poses[i].matrix() - first - share * change;
    const Eigen::Matrix3d turned = off.topLeftCorner<3, 3>();
    const Eigen::Vector3d moved = turned * middle + off.topRightCorner<3, 1>();
    farthest = std::max(farthest, moved.norm() + turned.norm() * radius);
  }
  return farthest;
}

}  // namespace

/// Draws an item on a face, one group of rows after the other.
///
/// The places of its vertices at the times of the first and the last row of the group determine in
/// which rows a triangle may be seen; in each of these rows it is drawn where it is at that time.
class RowRaster::OnRows {
 public:
  OnRows(const RowRaster& raster, std::size_t face, const DrawItem& item, int number)
      : poses_(raster.poses_),
        rows_(raster.grids_[face]),
        rays_(rows_.grid),
        item_(item),
        number_(number),
        X_FC_(raster.lens_.faces[face].X_CF.inverse()),
        near_(raster.lens_.faces[face].camera.near()),
        drawing_(raster.lens_.faces[face], rays_, item, raster.is_hole_) {}

  template <class See>
  void draw(See& see) {
    constexpr int kRows = 24;
    for (int first = 0; first < poses_.rowCount(); first += kRows) {
      const int end = std::min(first + kRows, poses_.rowCount());
      takeRows(first, end);
      if (bounds_.left <= bounds_.right && mayBeSeen()) drawTriangles(see);
    }
  }

 private:
  /// A vertex at the times of the first and the last row.
  struct Way {
    float left, top, right, bottom;
    int kept;          ///< at how many of both times it is beyond the near plane
    bool may_be_seen;  ///< at one of the two times or between them
  };

  void takeRows(int first, int end) {
    constexpr float kFar = std::numeric_limits<float>::infinity();
    first_row_ = first;
    bounds_ = {kFar, kFar, -kFar, -kFar};
    for (int row = first; row < end; ++row)
      bounds_.extend(rows_.rows[static_cast<std::size_t>(row)]);
    if (bounds_.left > bounds_.right) return;
    X_FV_.clear();
    for (int row = first; row < end; ++row) X_FV_.push_back(X_FC_ * poses_.X_CV(number_, row));
  }

  /// Whether any part of the item's bounds may be seen in these rows; also sets bend_ and margin_.
  [[nodiscard]] bool mayBeSeen() {
    if (item_.bounds_V.isEmpty()) return false;
    const Intrinsics& k = rows_.grid.intrinsics;
    std::array<bool, 5> beside = {true, true, true, true, true};
    double nearest = std::numeric_limits<double>::infinity();
    const auto corners = cornersOf(item_.bounds_V);
    for (const Pose* pose : {&X_FV_.front(), &X_FV_.back()}) {
      for (const Eigen::Vector3d& corner : corners) {
        nearest = std::min(nearest, (*pose * corner).z());
      }
    }
    const Pose& before = X_FV_.front();
    const Pose& after = X_FV_.back();
    bend_ = farthestFromLine(item_.bounds_V, X_FV_);
    constexpr double kLeast = 0.5;  // [cell]
    margin_ = static_cast<float>(kLeast + 2.0 * std::max(k.fx, k.fy) * bend_ /
                                              std::max(nearest - bend_, near_));
    const double margin = static_cast<double>(margin_);
    for (const Pose* pose : {&before, &after}) {
      for (const Eigen::Vector3d& corner : corners) {
        const Eigen::Vector3d p = *pose * corner;
        const double column = k.fx * p.x() + k.cx * p.z();
        const double row = k.fy * p.y() + k.cy * p.z();
        beside[0] &= p.z() < near_ - bend_;
        beside[1] &= column < (static_cast<double>(bounds_.left) - margin) * p.z();
        beside[2] &= row < (static_cast<double>(bounds_.top) - margin) * p.z();
        beside[3] &= column > (static_cast<double>(bounds_.right) + margin) * p.z();
        beside[4] &= row > (static_cast<double>(bounds_.bottom) + margin) * p.z();
      }
    }
    return std::none_of(beside.begin(), beside.end(), [](bool each) { return each; });
  }

  template <class See>
  void drawTriangles(See& see) {
    const world::Mesh& mesh = *item_.shape;
    ways_.clear();
    ways_.reserve(mesh.positions.size());
    for (const Eigen::Vector3f& position : mesh.positions) {
      ways_.push_back(wayOf(position.cast<double>()));
    }
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      const Way& a = ways_[mesh.indices[i]];
      const Way& b = ways_[mesh.indices[i + 1]];
      const Way& c = ways_[mesh.indices[i + 2]];
      if (!a.may_be_seen && !b.may_be_seen && !c.may_be_seen) continue;
      RowRayGrid::Bounds around = bounds_;
      if (a.kept + b.kept + c.kept == 6) {
        around = {std::min({a.left, b.left, c.left}) - margin_,
                  std::min({a.top, b.top, c.top}) - margin_,
                  std::max({a.right, b.right, c.right}) + margin_,
                  std::max({a.bottom, b.bottom, c.bottom}) + margin_};
        if (!meets(around, bounds_)) continue;
      }
      drawTriangle(static_cast<std::uint32_t>(i), around, see);
    }
  }

  [[nodiscard]] Way wayOf(const Eigen::Vector3d& point_V) const {
    constexpr float kFar = std::numeric_limits<float>::infinity();
    Way way{kFar, kFar, -kFar, -kFar, 0, false};
    for (const Pose* pose : {&X_FV_.front(), &X_FV_.back()}) {
      const FaceCorner corner = drawing_.cornerAt(*pose * point_V);
      way.may_be_seen |= corner.point_F.z() >= near_ - bend_;
      if (!(corner.point_F.z() >= near_)) continue;
      ++way.kept;
      way.left = std::min(way.left, corner.place.x());
      way.top = std::min(way.top, corner.place.y());
      way.right = std::max(way.right, corner.place.x());
      way.bottom = std::max(way.bottom, corner.place.y());
    }
    return way;
  }

  [[nodiscard]] static bool meets(const RowRayGrid::Bounds& one, const RowRayGrid::Bounds& other) {
    return one.left <= other.right && one.right >= other.left && one.top <= other.bottom &&
           one.bottom >= other.top;
  }

  template <class See>
  void drawTriangle(std::uint32_t first, const RowRayGrid::Bounds& around, See& see) {
    const world::Mesh& mesh = *item_.shape;
    const auto corner = [&](const Pose& X_FV, std::uint32_t i) {
      return drawing_.cornerAt(X_FV * mesh.positions[mesh.indices[first + i]].cast<double>());
    };
    for (std::size_t i = 0; i < X_FV_.size(); ++i) {
      const int row = first_row_ + static_cast<int>(i);
      if (!meets(around, rows_.rows[static_cast<std::size_t>(row)])) continue;
      rays_.goTo(row);
      see.beginTriangles(row);
      const FaceCorner a = corner(X_FV_[i], 0);
      const FaceCorner b = corner(X_FV_[i], 1);
      const FaceCorner c = corner(X_FV_[i], 2);
      drawing_.drawTriangle(first, a, b, c, see);
    }
  }

  const RowPoses& poses_;
  const RowRayGrid& rows_;
  RowRays rays_;
  const DrawItem& item_;
  int number_;
  Pose X_FC_;
  double near_;
  FaceDrawing<RowRays> drawing_;

  // The group of rows that is being drawn.
  int first_row_ = 0;
  RowRayGrid::Bounds bounds_{};
  std::vector<Pose> X_FV_;  ///< of each row
  double bend_ = 0.0;       ///< how far vertices' paths are at most from straight lines [m]
  float margin_ = 0.0F;     ///< the same in the picture [cell]
  std::vector<Way> ways_;
};

void RowRaster::draw(const DrawItem& item, int number, RaySights& sights) const {
  for (std::size_t face = 0; face < grids_.size(); ++face) {
    SightRecorder see(item, number, face, sights);
    OnRows(*this, face, item, number).draw(see);
  }
}

void RowRaster::visitCovered(const DrawItem& item, int number,
                             const std::function<void(int ray)>& visit) const {
  for (std::size_t face = 0; face < grids_.size(); ++face) {
    CoveredRays see{grids_[face].grid.rays, item.has_holes, visit};
    OnRows(*this, face, item, number).draw(see);
  }
}

}  // namespace synthetic_dataset::render
