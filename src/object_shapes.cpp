#include "object_shapes.h"

#include <string>
#include <utility>

#include "error_collector.h"

namespace synthetic_dataset {
namespace {

std::vector<const world::Link*> linksAt(const std::vector<world::LinkInstance>& links,
                                        const std::vector<std::size_t>& indices) {
  std::vector<const world::Link*> result;
  for (const std::size_t index : indices) result.push_back(links[index].link);
  return result;
}

std::string needsVisuals(const config::ObjectConfig& object, const std::string& parameter,
                         const std::string& what, const std::string& instead) {
  return object.name + "/" + parameter + ": " + what +
         " is found on the model's visuals, and that of '" + object.name +
         "' has none; add a visual to the model, or " + instead;
}

}  // namespace

Cuboid boxRound(const std::vector<Eigen::Vector3d>& points) {
  Cuboid box{points.front(), points.front()};
  for (const Eigen::Vector3d& point : points) {
    box.low = box.low.cwiseMin(point);
    box.high = box.high.cwiseMax(point);
  }
  return box;
}

ObjectShapes::ObjectShapes(const std::vector<config::ObjectConfig>& objects,
                           const std::vector<world::LinkInstance>& links) {
  ErrorCollector errors;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const config::ObjectConfig& config = objects[i];
    Object object;
    object.given = {config.name,        config.class_text,       config.class_name,
                    config.id,          config.class_id,         static_cast<int>(i) + 1,
                    config.keypoints_O, config.bounding_shape_O, {}};
    for (std::size_t k = 0; k < links.size(); ++k) {
      if (links[k].object == static_cast<int>(i)) object.links.push_back(k);
    }
    const std::vector<const world::Link*> own = linksAt(links, object.links);
    if (!config.takes_part && !config.is_distractor) {
      objects_.push_back(withoutShape(std::move(object), config));
      continue;
    }
    const world::ModelGeometry geometry(own);
    object.geometry = geometry;
    if (config.bounding_shape_O.empty() && geometry.isEmpty()) {
      errors.add(needsVisuals(config, "bounding_shape", "model_box", "list points here"));
    }
    if (config.farthest_points > 0 && geometry.isEmpty()) {
      errors.add(needsVisuals(config, "keypoints", "farthest_points", "list points here"));
    } else if (config.farthest_points > 0) {
      try {
        object.keypoints = world::farthestPoints(own, config.farthest_points);
      } catch (const Error& error) {
        errors.add(config.name + "/keypoints: " + error.what());
      }
    }
    std::vector<Pose> X_OL;
    for (const world::Link* link : own) X_OL.push_back(link->X_ML);
    if (!geometry.isEmpty()) {
      object.box_at_rest_O = boxRound(geometry.box(X_OL));
    } else if (!config.bounding_shape_O.empty()) {
      object.box_at_rest_O = boxRound(config.bounding_shape_O);
    }
    objects_.push_back(std::move(object));
  }
  errors.throwIfAny();
}

/// It has no label, but as many keypoints as elsewhere.
ObjectShapes::Object ObjectShapes::withoutShape(Object object, const config::ObjectConfig& config) {
  object.given.bounding_shape_O = {Eigen::Vector3d::Zero()};
  const std::size_t count = config.farthest_points > 0
                                ? static_cast<std::size_t>(config.farthest_points)
                                : config.keypoints_O.size();
  object.given.keypoints_O.assign(count, Eigen::Vector3d::Zero());
  return object;
}

std::vector<Cuboid> ObjectShapes::boxesAtRest() const {
  std::vector<Cuboid> boxes;
  for (const Object& object : objects_) boxes.push_back(object.box_at_rest_O);
  return boxes;
}

std::vector<annotate::ObjectShape> ObjectShapes::at(const std::vector<Pose>& X_WL,
                                                    const std::vector<Pose>& X_WO) const {
  std::vector<annotate::ObjectShape> shapes;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const Object& object = objects_[i];
    annotate::ObjectShape shape = object.given;
    std::vector<Pose> X_OL;
    for (const std::size_t link : object.links) X_OL.push_back(X_WO[i].inverse() * X_WL[link]);
    const bool is_seen = !object.geometry.isEmpty();
    if (is_seen && shape.bounding_shape_O.empty()) {
      shape.bounding_shape_O = object.geometry.box(X_OL);
    }
    shape.cuboid_O = boxRound(is_seen ? object.geometry.box(X_OL) : shape.bounding_shape_O);
    for (const world::SurfacePoint& point : object.keypoints) {
      shape.keypoints_O.push_back(X_OL[point.link] * point.p_L);
    }
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

}  // namespace synthetic_dataset
