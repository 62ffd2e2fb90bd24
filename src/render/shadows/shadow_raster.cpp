#include "render/shadows/shadow_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {
namespace {

constexpr float kFarthest = 1.0F;
constexpr float kSteps = 256.0F;  // of a texel, to which corners are rounded

/// A corner in the map: column and row, so that texels' centres are whole numbers; depth.
using Corners = std::vector<Eigen::Vector3f>;

Corners cornersOf(const world::Mesh& mesh, const Eigen::Affine3f& map_from_mesh) {
  Corners corners;
  corners.reserve(mesh.positions.size());
  for (const Eigen::Vector3f& position : mesh.positions) {
    const Eigen::Vector3f place = map_from_mesh * position;
    corners.emplace_back(std::round((place.x() - 0.5F) * kSteps) / kSteps,
                         std::round((place.y() - 0.5F) * kSteps) / kSteps, place.z());
  }
  return corners;
}

/// The texels of a map whose centres are between these places.
cv::Rect texelsBetween(const Eigen::Vector3f& lowest, const Eigen::Vector3f& highest, int size) {
  const Eigen::Vector3f beside = Eigen::Vector3f::Constant(static_cast<float>(size) + 1.0F);
  const Eigen::Vector3f low = lowest.cwiseMax(-beside).cwiseMin(beside);
  const Eigen::Vector3f high = highest.cwiseMax(-beside).cwiseMin(beside);
  const cv::Point first(static_cast<int>(std::ceil(low.x())), static_cast<int>(std::ceil(low.y())));
  const cv::Point last(static_cast<int>(std::floor(high.x())),
                       static_cast<int>(std::floor(high.y())));
  if (first.x > last.x || first.y > last.y) return {};
  return cv::Rect(first, last + cv::Point(1, 1)) & cv::Rect(0, 0, size, size);
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
struct Side {
  Side(const Eigen::Vector3f& from, const Eigen::Vector3f& to)
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

class PieceRaster {
 public:
  PieceRaster(MapPiece& piece, int size) : piece_(piece), size_(size) {}

  void draw(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
    const Eigen::Vector3f low = a.cwiseMin(b).cwiseMin(c);
    const Eigen::Vector3f high = a.cwiseMax(b).cwiseMax(c);
    const cv::Rect texels = texelsBetween(low, high, size_) & piece_.texels;
    if (texels.empty()) return;
    const std::array<Side, 3> sides = {Side(a, b), Side(b, c), Side(c, a)};
    const Eigen::Vector2f slope = slopeOf(a, b, c);
    const float nearest = std::clamp(low.z(), 0.0F, kFarthest);
    const float farthest = std::clamp(high.z(), 0.0F, kFarthest);
    // Whole lanes: the piece has room for them behind its last column.
    for (int row = texels.y; row < texels.y + texels.height; ++row) {
      auto* depths = piece_.depths.ptr<float>(row - piece_.texels.y, texels.x - piece_.texels.x);
      const float first_depth = a.z() + slope.x() * (static_cast<float>(texels.x) - a.x()) +
                                slope.y() * (static_cast<float>(row) - a.y());
      std::array<float, 3> first{};
      for (std::size_t i = 0; i < 3; ++i) first[i] = sides[i].at(texels.x, row);
      for (int column = 0; column < texels.width; column += kLaneCount) {
        const Lanes steps = lanes(static_cast<float>(column)) + Lanes(0.0F, 1.0F, 2.0F, 3.0F);
        const Lanes zero = lanes(0.0F);
        const Lanes covered = (lanes(first[0]) + lanes(sides[0].along_column) * steps >= zero) &
                              (lanes(first[1]) + lanes(sides[1].along_column) * steps >= zero) &
                              (lanes(first[2]) + lanes(sides[2].along_column) * steps >= zero);
        if (!cv::v_check_any(covered)) continue;
        // Within the corners', whatever the slope of a sliver is.
        const Lanes depth =
            clamped(lanes(first_depth) + lanes(slope.x()) * steps, nearest, farthest);
        float* at = depths + column;
        const Lanes before = cv::v_load(at);
        cv::v_store(at, cv::v_select(covered, cv::v_min(depth, before), before));
      }
    }
  }

 private:
  /// Of depth, a texel along columns and rows.
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

std::optional<MapPiece> castPiece(const world::Mesh& mesh, const Eigen::Affine3f& map_from_mesh,
                                  int size, bool fronts_alone) {
  const Corners corners = cornersOf(mesh, map_from_mesh);
  MapPiece piece;
  piece.texels = texelsOf(corners, size);
  if (piece.texels.empty()) return std::nullopt;
  const cv::Mat roomy(piece.texels.height, piece.texels.width + kLaneCount, CV_32FC1,
                      cv::Scalar(kFarthest));
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
