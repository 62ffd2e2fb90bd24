#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "render/lens/lens_map.h"
#include "render/lens/ray_grid.h"
#include "render/parts/draw_list.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// A triangle that a ray sees.
struct SeenTriangle {
  int item = 0;             ///< its number in the draw list
  std::uint32_t first = 0;  ///< position in Mesh::indices of the first of its three indices
  bool is_front = true;
  int row = -1;  ///< of the picture, at whose time it is seen; -1 if all rows have the same time
};

/// What rays see of the items drawn so far.
struct RaySights {
  std::vector<std::vector<float>> inverse_depths;  ///< of each grid's rays, along the face's axis
  std::vector<std::vector<int>> triangles;  ///< the same rays' indices in `seen`; -1: nothing
  std::vector<SeenTriangle> seen;

  /// Starts with rays that see nothing.
  explicit RaySights(const std::vector<RayGrid>& grids);
  explicit RaySights(const std::vector<RowRayGrid>& grids);

 private:
  void add(const RayGrid& grid);
};

/// Finds exactly what rays through a lens see, by drawing triangles on the lens's faces at the
/// places of these rays only.
class RayRaster {
 public:
  /// A ray's place on a triangle of an item, to look up holes in its texture.
  struct Place {
    std::array<Eigen::Vector3f, 3> corners_F;  ///< in the face's frame
    std::array<std::uint32_t, 3> vertices;     ///< of the mesh
    Intrinsics intrinsics;                     ///< of the face, in cells
    float column, row;                         ///< [cell]
  };
  using IsHole = std::function<bool(const DrawItem&, const Place&)>;

  /// The references have to outlive this.
  /// @param grids  of each of the lens's faces
  /// @param is_hole  whether an item with holes has one at a place
  RayRaster(const View& view, const LensMap& lens, const std::vector<RayGrid>& grids,
            const IsHole& is_hole)
      : view_(view), lens_(lens), grids_(grids), is_hole_(is_hole) {}

  /// Draws an item; rays then see whatever is nearer, it or what was drawn before.
  void draw(const DrawItem& item, int number, const Pose& X_WL, RaySights& sights) const;

  /// Calls visit(index), possibly several times, for each ray that would see the item if there were
  /// no others.
  void visitCovered(const DrawItem& item, const Pose& X_WL,
                    const std::function<void(int ray)>& visit) const;

 private:
  class OnFace;

  const View& view_;
  const LensMap& lens_;
  const std::vector<RayGrid>& grids_;
  const IsHole& is_hole_;
};

}  // namespace synthetic_dataset::render
