#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "world/sdf/element.h"
#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// An element's `<origin>`: metres, and roll, pitch, yaw in radians about fixed axes.
/// @param location  of `parent`
[[nodiscard]] Pose readUrdfOrigin(const Element& parent, const SourceLocation& location,
                                  SdfReading& reading);

/// How Gazebo shows a link, according to its `<gazebo reference="...">`.
struct GazeboLook {
  std::optional<Material> material = std::nullopt;  ///< replaces all others
  float transparency = 0.0F;
  bool casts_shadow = true;
};

/// Reads the visuals and collisions of a robot's links.
class UrdfShapeReader {
 public:
  /// @param robot  the file's root element, where materials may be defined for all
  UrdfShapeReader(const Element& robot, SdfReading& reading);

  /// URDF's own material is used for shapes that have none, as in rviz: a mesh file's materials
  /// take precedence.
  /// @param location  the link's
  [[nodiscard]] std::vector<Visual> visuals(const Element& link, const GazeboLook& look,
                                            const SourceLocation& location);

  /// No picture needs collisions: a missing file is noted, and its collision left out.
  [[nodiscard]] std::vector<Collision> collisions(const Element& link,
                                                  const SourceLocation& location);

  /// COLLADA files that declare that y points up.
  [[nodiscard]] const std::set<std::string>& yUpMeshes() const { return y_up_meshes_; }

 private:
  [[nodiscard]] std::optional<Visual> visual(const Element& element, const GazeboLook& look,
                                             const SourceLocation& link,
                                             const SourceLocation& location);
  [[nodiscard]] std::optional<Material> material(const Element& visual, const SourceLocation& link,
                                                 const SourceLocation& location);
  void define(const Element& material);

  SdfReading& reading_;
  std::map<std::string, Element> materials_;  ///< by name; the first one counts
  std::set<std::string> y_up_meshes_;
};

}  // namespace synthetic_dataset::world
