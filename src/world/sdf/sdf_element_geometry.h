#pragma once

/// The kinds of geometry that libsdformat, at least in some version, leaves to be read from the
/// file's elements.

#include <optional>

#include <sdf/Element.hh>

#include "world/sdf/sdf_reading.h"
#include "world/shape/extrusion.h"
#include "world/shape/heightmap.h"
#include "world/shape/wall_map.h"

namespace synthetic_dataset::world {

/// Checks a length. @return 1 where it is none (reported)
[[nodiscard]] double readSize(const std::string& name, double value, const Place& place,
                              SdfReading& reading);

/// The file that a URI means in an element's file, or nothing where there is none (reported).
/// @param kind  for the message: "mesh", "heightmap"
[[nodiscard]] std::optional<std::filesystem::path> readFile(const std::string& kind,
                                                            const std::string& uri,
                                                            const sdf::ElementPtr& element,
                                                            const Place& place,
                                                            SdfReading& reading);

/// All `<polyline>` of a `<geometry>`, which make one shape of the first one's height.
[[nodiscard]] std::optional<Extrusion> readPolylines(const sdf::ElementPtr& geometry,
                                                     const Place& place, SdfReading& reading);

[[nodiscard]] std::optional<Heightmap> readHeightmap(const sdf::ElementPtr& element,
                                                     const Place& place, SdfReading& reading);

/// @param element  an `<image>`
[[nodiscard]] std::optional<WallMap> readWallMap(const sdf::ElementPtr& element, const Place& place,
                                                 SdfReading& reading);

}  // namespace synthetic_dataset::world
