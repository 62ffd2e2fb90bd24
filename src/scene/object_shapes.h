#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "label/object_labels.h"
#include "scene/object_options.h"
#include "scene/object_variants.h"
#include "world/mesh/model_geometry.h"
#include "world/mesh/surface_points.h"
#include "world/world.h"

namespace synthetic_dataset::scene {

/// The axis-aligned bounding box of points, of which there has to be at least one.
[[nodiscard]] Cuboid boxAround(const std::vector<Eigen::Vector3d>& points);

/// Maps a point of an object's own model to its position in a variant of another shape, in the
/// object's frame; empty: the position is unchanged.
using PointChange = std::function<Eigen::Vector3d(const Eigen::Vector3d& p_O)>;

/// The objects' keypoints and bounding shapes: as given by the parameters, in the size and shape of
/// the active variants, or found on these variants, scene by scene.
class ObjectShapes {
 public:
  /// @param variants  of each object
  /// @param world  has to outlive this
  /// @param changes_O  of each object's variants; may be empty
  /// @throws ErrorList naming the parameters that need a model with visuals
  ObjectShapes(const std::vector<ObjectOptions>& objects,
               const std::vector<ObjectVariants>& variants, const world::World& world,
               const std::vector<std::vector<PointChange>>& changes_O = {});

  [[nodiscard]] std::size_t size() const { return objects_.size(); }

  /// The bounding box of each variant of an object in the object's frame, with the links as in the
  /// model.
  [[nodiscard]] std::vector<Cuboid> boxesAtRest(std::size_t object) const;

  /// The shapes of all objects in the world's current state.
  [[nodiscard]] std::vector<label::ObjectShape> at(
      const std::vector<std::optional<Pose>>& X_WO) const;

 private:
  struct Variant {
    label::ObjectShape given;
    std::vector<std::size_t> links;  ///< indices in the world's links
    world::ModelGeometry geometry{{}};
    Cuboid box_at_rest_O;
    std::vector<world::SurfacePoint> keypoints;  ///< chosen on the model
  };
  using Object = std::vector<Variant>;

  [[nodiscard]] Variant measure(Variant variant, const ObjectOptions& config) const;
  [[nodiscard]] label::ObjectShape shapeOf(const Variant& variant,
                                           const std::optional<Pose>& X_WO) const;

  const world::World& world_;
  std::vector<Object> objects_;
};

}  // namespace synthetic_dataset::scene
