#include "randomize/appearance/room.h"

#include <algorithm>
#include <string>
#include <utility>

#include "world/material/material_conversions.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::randomize {
namespace {

world::Material chalky(const RoomOptions& options, const Eigen::Vector2d& shown) {
  world::Material material;
  material.specular.setZero();
  material.roughness = 0.9F;
  material.shininess = world::shininessOfRoughness(material.roughness);
  material.texture_scale = (shown / options.tile).cast<float>();
  return material;
}

/// Adds a slab of which one face is visible.
/// @param shown  size of that face, across and up [m]
void addSlab(const std::string& name, const Eigen::Vector3d& centre, const Eigen::Vector3d& size,
             const Eigen::Vector2d& shown, const RoomOptions& options, world::Link& link) {
  const Pose X_LS = makePose(centre, Eigen::Quaterniond::Identity());
  world::Visual visual;
  visual.name = name;
  visual.X_LV = X_LS;
  visual.casts_shadow = name != "floor";
  visual.surfaces.push_back({world::boxMesh(size), chalky(options, shown)});
  world::Collision collision;
  collision.name = name;
  collision.X_LC = X_LS;
  collision.shape = world::BoxShape{size};
  link.visuals.push_back(std::move(visual));
  link.collisions.push_back(std::move(collision));
}

}  // namespace

world::Model makeRoom(const RoomOptions& options) {
  constexpr double kThickness = 0.1;  // of the room's shorter side, so that nothing falls through
  const double x = options.size.x();
  const double y = options.size.y();
  const double z = options.size.z();
  const double thick = kThickness * std::min(x, y);
  world::Link link;
  link.name = "link";
  addSlab("floor", {0, 0, -0.5 * thick}, {x, y, thick}, {y, x}, options, link);
  if (z > 0.0) {
    const double from_x = 0.5 * (x + thick);
    const double from_y = 0.5 * (y + thick);
    addSlab("wall_1", {from_x, 0, 0.5 * z}, {thick, y, z}, {y, z}, options, link);
    addSlab("wall_2", {-from_x, 0, 0.5 * z}, {thick, y, z}, {y, z}, options, link);
    addSlab("wall_3", {0, from_y, 0.5 * z}, {x, thick, z}, {x, z}, options, link);
    addSlab("wall_4", {0, -from_y, 0.5 * z}, {x, thick, z}, {x, z}, options, link);
  }
  world::Model model;
  model.name = kRoomName;
  model.is_static = true;
  model.links.push_back(std::move(link));
  return model;
}

}  // namespace synthetic_dataset::randomize
