#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "world/description.h"
#include "world/material/material_source.h"
#include "world/material/texture_loader.h"

namespace synthetic_dataset::world {

/// A ground texture of a heightmap.
struct GroundTexture {
  std::string diffuse;  ///< URI
  std::string normal;   ///< URI; may be empty
  double size = 10.0;   ///< of one tile [m]
};

/// The height above which the next texture covers the ones before it.
struct GroundBlend {
  double min_height = 0.0;  ///< [m] above the lowest point that the picture can describe
  double fade_dist = 0.0;   ///< range of height over which it becomes opaque [m]
};

/// SDF's <heightmap>: a picture whose brightest pixel has the height that the size gives. Its first
/// row is at +y.
struct Heightmap {
  std::filesystem::path file;
  Eigen::Vector3d size{1, 1, 1};    ///< [m]; a negative z turns it upside down
  Eigen::Vector3d centre{0, 0, 0};  ///< of its ground [m]
  unsigned sampling = 1;            ///< steps from one pixel to the next
  std::vector<GroundTexture> textures;
  std::vector<GroundBlend> blends;  ///< of the second texture and those after it
  std::filesystem::path folder;     ///< of the file that names the textures
};

/// Points of the ground, row by row, the first row at +y.
struct HeightGrid {
  int columns = 0;
  int rows = 0;
  std::vector<float> heights;  ///< above the ground's level [m]
};

/// The heights of a heightmap. Pictures may have any size; the grid has at most 1025 points on a
/// side.
/// @throws Error naming the picture
[[nodiscard]] HeightGrid readHeights(const Heightmap& heightmap);

/// The heightmap's triangles, for collisions. A texture repeats every metre.
/// @throws Error as readHeights
[[nodiscard]] std::shared_ptr<const Mesh> heightmapMesh(const Heightmap& heightmap);

/// The heightmap's triangles in its textures: the lowest one opaque, then each further one over it,
/// with its weight at each point as the alpha of the mesh's colours, where that weight is above 0.
/// Without textures, in `plain`.
/// @param missing  called for each picture that is missing and left out
/// @throws Error as readHeights
[[nodiscard]] std::vector<Surface> heightmapSurfaces(const Heightmap& heightmap,
                                                     const Material& plain, TextureLoader& textures,
                                                     const MissingPicture& missing);

}  // namespace synthetic_dataset::world
