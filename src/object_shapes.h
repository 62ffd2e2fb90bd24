#pragma once

#include <optional>
#include <vector>

#include "annotate/object_labels.h"
#include "config/config.h"
#include "world/mesh/model_geometry.h"
#include "world/mesh/surface_points.h"
#include "world/world.h"

namespace synthetic_dataset {

/// The objects' keypoints and bounding shapes: as the parameters give them, or found on the models,
/// scene by scene.
class ObjectShapes {
 public:
  /// @param links  of the world
  /// @throws ErrorList naming the parameters that need a model that can be seen
  ObjectShapes(const std::vector<config::ObjectConfig>& objects,
               const std::vector<world::LinkInstance>& links);

  [[nodiscard]] std::size_t size() const { return objects_.size(); }

  /// The shapes of all objects as the links stand.
  /// @param X_WL  of the world's links
  [[nodiscard]] std::vector<annotate::ObjectShape> at(const std::vector<Pose>& X_WL,
                                                      const std::vector<Pose>& X_WO) const;

 private:
  struct Object {
    annotate::ObjectShape given;
    std::vector<std::size_t> links;  ///< indices in the world's
    world::ModelGeometry geometry{{}};
    std::vector<world::SurfacePoint> keypoints;  ///< where they were found on the model
  };

  std::vector<Object> objects_;
};

}  // namespace synthetic_dataset
