#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <urdf_model/link.h>

#include "world/description.h"
#include "world/files/findings.h"
#include "world/files/resource_finder.h"
#include "world/mesh/mesh_loader.h"
#include "world/shape/shape_cache.h"
#include "world/urdf/urdf_text.h"

namespace synthetic_dataset::world {

/// One URDF text being read.
struct UrdfReading {
  const ModelText& source;
  const ResourceFinder& finder;
  MeshLoader& meshes;
  ShapeCache& shapes;
  Findings& findings;
  std::set<std::string> y_up_meshes = {};  ///< COLLADA files that say that y points up
};

/// A pose of the file; one that is not finite is an error.
[[nodiscard]] Pose toPose(const urdf::Pose& pose, const SourceLocation& location,
                          UrdfReading& reading);

/// @param gazebo_material  the link's for Gazebo, or nothing: as Gazebo shows it, it takes the
///     place of all others. URDF's own material is for what has none, as in rviz: a mesh file's
///     materials stand.
/// @param location  the link's
/// @return nothing for an error, which is reported, and for a visual whose URDF's colour is wholly
///     transparent
[[nodiscard]] std::optional<Visual> readUrdfVisual(const urdf::Visual& visual,
                                                   const std::string& name,
                                                   const std::optional<Material>& gazebo_material,
                                                   const SourceLocation& location,
                                                   UrdfReading& reading);

/// @param location  the link's
/// @return nothing for an error, which is reported
[[nodiscard]] std::optional<Collision> readUrdfCollision(const urdf::Collision& collision,
                                                         const std::string& name,
                                                         const SourceLocation& location,
                                                         UrdfReading& reading);

}  // namespace synthetic_dataset::world
