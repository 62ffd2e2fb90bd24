#pragma once

#include <filesystem>
#include <memory>

#include "world/description.h"

namespace synthetic_dataset::world {

/// SDF's <image>: walls where a picture is dark. Each pixel is a square; the first one is at the
/// origin, columns run along x and rows along y, as in Gazebo's MapShape.
struct WallMap {
  std::filesystem::path file;
  double scale = 1.0;   ///< length of a pixel's side [m]
  double height = 1.0;  ///< of the walls, from z = 0 [m]
  int threshold = 200;  ///< pixels whose mean of red, green, blue (0 to 255) is above it are free
  int granularity = 1;  ///< how many pixels share one block, which is a wall if any of them is
};

/// The walls as boxes; blocks are joined along x, then along y, to keep the boxes few.
/// @throws Error naming the picture if it cannot be read, or has no walls or too many
[[nodiscard]] std::shared_ptr<const Mesh> wallMesh(const WallMap& map);

}  // namespace synthetic_dataset::world
