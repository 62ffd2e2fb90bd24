#pragma once

#include <optional>
#include <vector>

#include "annotate/object_labels.h"
#include "config/config.h"
#include "world/mesh/model_geometry.h"
#include "world/mesh/surface_points.h"
#include "world/world.h"

namespace synthetic_dataset {

/// The smallest box along the axes round points, of which there is one at least.
[[nodiscard]] Cuboid boxRound(const std::vector<Eigen::Vector3d>& points);

/// The objects' keypoints and bounding shapes: as the parameters give them, or found on the models,
/// scene by scene.
class ObjectShapes {
 public:
  /// @param links  of the world
  /// @throws ErrorList naming the parameters that need a model that can be seen
  ObjectShapes(const std::vector<config::ObjectConfig>& objects,
               const std::vector<world::LinkInstance>& links);

  [[nodiscard]] std::size_t size() const { return objects_.size(); }

  /// A box round each object in its own frame, its links as the model has them.
  [[nodiscard]] std::vector<Cuboid> boxesAtRest() const;

  /// The shapes of all objects as the links stand.
  /// @param X_WL  of the world's links
  [[nodiscard]] std::vector<annotate::ObjectShape> at(const std::vector<Pose>& X_WL,
                                                      const std::vector<Pose>& X_WO) const;

 private:
  struct Object {
    annotate::ObjectShape given;
    std::vector<std::size_t> links;  ///< indices in the world's
    world::ModelGeometry geometry{{}};
    Cuboid box_at_rest_O;
    std::vector<world::SurfacePoint> keypoints;  ///< where they were found on the model
  };

  [[nodiscard]] static Object withoutShape(Object object, const config::ObjectConfig& config);

  std::vector<Object> objects_;
};

}  // namespace synthetic_dataset
