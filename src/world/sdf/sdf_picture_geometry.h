#pragma once

/// The geometries that are made from outlines and pictures, and helpers shared with the others.

#include <filesystem>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "world/sdf/sdf_reading.h"
#include "world/shape/extrusion.h"
#include "world/shape/heightmap.h"
#include "world/shape/wall_map.h"

namespace synthetic_dataset::world {

/// @return the value
/// @throws Error if it is not a length: above 0 and at most 1e7 m
double requireSize(const std::string& name, double value);

/// The file to which a URI in an element's file refers, or nothing if there is none (reported).
/// @param kind  for the message: "mesh", "heightmap"
[[nodiscard]] std::optional<std::filesystem::path> findFile(const std::string& kind,
                                                            const std::string& uri,
                                                            const Element& element,
                                                            const SourceLocation& location,
                                                            SdfReading& reading);

/// Reads all `<polyline>`s of a `<geometry>`, which form one shape with the height of the first.
/// @throws Error for a height or a point that is invalid
[[nodiscard]] Extrusion readPolylines(const Element& geometry, const Eigen::Vector3d& scale,
                                      const SourceLocation& location, SdfReading& reading);

/// @throws Error for invalid sizes
[[nodiscard]] std::optional<Heightmap> readHeightmap(const Element& element,
                                                     const Eigen::Vector3d& scale,
                                                     const SourceLocation& location,
                                                     SdfReading& reading);

/// @param element  an `<image>`
/// @throws Error for invalid sizes
[[nodiscard]] std::optional<WallMap> readWallMap(const Element& element,
                                                 const SourceLocation& location,
                                                 SdfReading& reading);

}  // namespace synthetic_dataset::world
