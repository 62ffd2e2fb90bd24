#include "render/lens/ray_raster.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <Eigen/Geometry>

#include "render/lens/face_drawing.h"

namespace synthetic_dataset::render {

RaySights::RaySights(const std::vector<RayGrid>& grids) {
  for (const RayGrid& grid : grids) add(grid);
}

RaySights::RaySights(const std::vector<RowRayGrid>& grids) {
  for (const RowRayGrid& rows : grids) add(rows.grid);
}

void RaySights::add(const RayGrid& grid) {
  inverse_depths.emplace_back(grid.count() + RayGrid::kSpare, 0.0F);
  triangles.emplace_back(grid.count() + RayGrid::kSpare, -1);
}

/// Draws an item on a face.
class RayRaster::OnFace {
 public:
  OnFace(const RayRaster& raster, std::size_t face, const DrawItem& item, const Pose& X_WL)
      : grid_(raster.grids_[face]),
        rays_(grid_),
        item_(item),
        X_FV_((raster.view_.X_WC * raster.lens_.faces[face].X_CF).inverse() * X_WL * item.X_LV),
        near_(raster.lens_.faces[face].camera.near()),
        drawing_(raster.lens_.faces[face], rays_, item, raster.is_hole_) {}

  /// Whether any part of the item's bounds may be seen on the face.
  [[nodiscard]] bool mayBeSeen() const {
    if (item_.bounds_V.isEmpty()) return false;
    const Intrinsics& k = grid_.intrinsics;
    // Whether all corners are outside: nearer than the near plane, and beyond each side of the
    // grid.
    std::array<bool, 5> beside = {true, true, true, true, true};
    Eigen::AlignedBox2d box;
    bool is_ahead = true;
    for (const Eigen::Vector3d& corner : cornersOf(item_.bounds_V)) {
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

  template <class See>
  void draw(See&& see) {
    const world::Mesh& mesh = *item_.shape;
    std::vector<FaceCorner> corners;
    corners.reserve(mesh.positions.size());
    for (const Eigen::Vector3f& position : mesh.positions) {
      corners.push_back(drawing_.cornerAt(X_FV_ * position.cast<double>()));
    }
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      drawing_.drawTriangle(static_cast<std::uint32_t>(i), corners[mesh.indices[i]],
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

  const RayGrid& grid_;
  CellRays rays_;
  const DrawItem& item_;
  Pose X_FV_;
  double near_;
  FaceDrawing<CellRays> drawing_;
};

void RayRaster::draw(const DrawItem& item, int number, const Pose& X_WL, RaySights& sights) const {
  for (std::size_t face = 0; face < grids_.size(); ++face) {
    OnFace drawing(*this, face, item, X_WL);
    if (drawing.mayBeSeen()) drawing.draw(SightRecorder(item, number, face, sights));
  }
}

void RayRaster::visitCovered(const DrawItem& item, const Pose& X_WL,
                             const std::function<void(int ray)>& visit) const {
  for (std::size_t face = 0; face < grids_.size(); ++face) {
    OnFace drawing(*this, face, item, X_WL);
    if (!drawing.mayBeSeen()) continue;
    const std::vector<int>& rays = grids_[face].rays;
    drawing.draw(
        [&](std::size_t at, const Lanes& covered, const Lanes&, const FaceDrawing<CellRays>& here) {
          const int bits = cv::v_signmask(covered);
          for (std::size_t i = 0; i < kLaneCount; ++i) {
            if ((bits >> i & 1) == 0 || (item.has_holes && here.isHole(at + i))) continue;
            visit(rays[at + i]);
          }
        });
  }
}

}  // namespace synthetic_dataset::render
