#pragma once

#include <optional>
#include <vector>

#include "world/sdf/sdf_geometry.h"
#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// A mesh's triangles in the given material or, without one, in its own. Colours of an STL's facets
/// are some programs' own marks, and count where nobody gives it a colour.
/// @param fallback  of a mesh whose file has no material
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
/// @param scale  how much larger than the file says, by axis
/// @param location  the visual's
/// @return nothing where there is nothing to be seen, and in a survey
[[nodiscard]] std::optional<Visual> readVisual(const Element& visual, const Eigen::Vector3d& scale,
                                               const SourceLocation& location, SdfReading& reading);

}  // namespace synthetic_dataset::world
