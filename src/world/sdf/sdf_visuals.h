#pragma once

#include <optional>
#include <vector>

#include "world/sdf/sdf_geometry.h"
#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// A mesh's triangles in the given material or, without one, in its own. The facet colours of an
/// STL file are extensions of some programs, and are only used if no material is given.
/// @param fallback  material for a mesh whose file has none
/// @param location  of what is drawn, for pictures that are missing (reported)
/// @throws Error if the mesh cannot be read
[[nodiscard]] std::vector<Surface> meshSurfaces(const MeshRequest& request,
                                                const std::optional<Material>& material,
                                                const std::optional<Material>& fallback,
                                                const SourceLocation& location,
                                                SdfReading& reading);

/// The triangles of a geometry in the given material; without one, a mesh has its own.
/// @param location  of what is drawn
/// @throws Error if a mesh cannot be read
[[nodiscard]] std::vector<Surface> surfacesOf(const Geometry& geometry,
                                              const std::optional<Material>& material,
                                              const SourceLocation& location, SdfReading& reading);

/// @param visual  its pose is read by the caller, who knows the frames
/// @param scale  factors on the sizes in the file, by axis
/// @param location  the visual's
/// @return nothing if there is nothing to be seen, and in a survey
[[nodiscard]] std::optional<Visual> readVisual(const Element& visual, const Eigen::Vector3d& scale,
                                               const SourceLocation& location, SdfReading& reading);

}  // namespace synthetic_dataset::world
