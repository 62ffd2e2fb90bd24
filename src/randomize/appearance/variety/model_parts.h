#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

#include "world/description.h"

namespace synthetic_dataset::randomize {

/// A surface of a model, placed with the joints at rest.
struct SurfacePart {
  std::size_t link;
  std::size_t visual;
  std::size_t surface;
  Pose X_MV;
  std::vector<Eigen::Vector3d> p_M;  ///< of the mesh's vertices
  std::vector<std::size_t> piece;    ///< for each vertex, an index in the model's pieces
};

/// Connected triangles, possibly of several surfaces.
struct MeshPiece {
  Eigen::AlignedBox3d box_M;
  double area = 0.0;  ///< [m^2]
};

/// The parts of a model: its visuals' surfaces, and its connected pieces.
struct ModelParts {
  explicit ModelParts(const world::Model& model);

  std::vector<SurfacePart> surfaces;
  std::vector<MeshPiece> pieces;
  Eigen::AlignedBox3d box_M;  ///< empty if nothing is visible
  double area = 0.0;          ///< [m^2]
};

/// The area of a surface [m^2].
[[nodiscard]] double areaOf(const world::Surface& surface, const SurfacePart& part);

[[nodiscard]] inline const world::Surface& surfaceOf(const world::Model& model,
                                                     const SurfacePart& part) {
  return model.links[part.link].visuals[part.visual].surfaces[part.surface];
}
[[nodiscard]] inline world::Surface& surfaceOf(world::Model& model, const SurfacePart& part) {
  return model.links[part.link].visuals[part.visual].surfaces[part.surface];
}

}  // namespace synthetic_dataset::randomize
