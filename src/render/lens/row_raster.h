#pragma once

#include <functional>
#include <vector>

#include "render/lens/lens_map.h"
#include "render/lens/ray_grid.h"
#include "render/lens/ray_raster.h"
#include "render/lens/row_poses.h"
#include "render/parts/draw_list.h"

namespace synthetic_dataset::render {

/// Finds exactly what the rays see in a picture whose rows are taken one after the other: each ray
/// meets triangles where they are at the time of its own row.
class RowRaster {
 public:
  /// The references have to outlive this.
  /// @param grids  of each of the lens's faces
  /// @param is_hole  whether an item with holes has one at a place
  RowRaster(const RowPoses& poses, const LensMap& lens, const std::vector<RowRayGrid>& grids,
            const RayRaster::IsHole& is_hole)
      : poses_(poses), lens_(lens), grids_(grids), is_hole_(is_hole) {}

  /// Draws an item, as RayRaster does.
  void draw(const DrawItem& item, int number, RaySights& sights) const;

  /// Calls visit(index), possibly several times, for each ray that would see the item if there were
  /// no others.
  void visitCovered(const DrawItem& item, int number,
                    const std::function<void(int ray)>& visit) const;

 private:
  class OnRows;

  const RowPoses& poses_;
  const LensMap& lens_;
  const std::vector<RowRayGrid>& grids_;
  const RayRaster::IsHole& is_hole_;
};

}  // namespace synthetic_dataset::render
