#include "scene/object_shapes.h"

#include <string>
#include <utility>

#include "base/diagnostics.h"
#include "label/object_links.h"

namespace synthetic_dataset::scene {
namespace {

void needVisuals(const ObjectOptions& object, const std::string& parameter, const std::string& what,
                 base::Diagnostics& errors) {
  errors.error(object.name + "/" + parameter,
               what + " is found on the model's visuals, and that of '" + object.name +
                   "' has none; add a visual to the model, or list points here");
}

/// The shape that the parameters give, in a variant's shape and size.
label::ObjectShape givenShape(const ObjectOptions& config, int instance, const PointChange& change,
                              double scale) {
  label::ObjectShape shape{config.name,        config.class_text,       config.class_name,
                           config.id,          config.class_id,         instance,
                           config.keypoints_O, config.bounding_shape_O, {}};
  for (auto* points : {&shape.keypoints_O, &shape.bounding_shape_O}) {
    for (Eigen::Vector3d& point : *points) point = scale * (change ? change(point) : point);
  }
  return shape;
}

/// Clears the shape of an object that does not take part. It has no label, but as many keypoints as
/// in other motions.
void leaveOutShape(label::ObjectShape& shape, const ObjectOptions& config) {
  shape.bounding_shape_O = {Eigen::Vector3d::Zero()};
  const std::size_t count = config.farthest_points > 0
                                ? static_cast<std::size_t>(config.farthest_points)
                                : config.keypoints_O.size();
  shape.keypoints_O.assign(count, Eigen::Vector3d::Zero());
}

}  // namespace

Cuboid boxAround(const std::vector<Eigen::Vector3d>& points) {
  Cuboid box{points.front(), points.front()};
  for (const Eigen::Vector3d& point : points) {
    box.low = box.low.cwiseMin(point);
    box.high = box.high.cwiseMax(point);
  }
  return box;
}

ObjectShapes::ObjectShapes(const std::vector<ObjectOptions>& objects,
                           const std::vector<ObjectVariants>& variants, const world::World& world,
                           const std::vector<std::vector<PointChange>>& changes_O)
    : world_(world) {
  base::Diagnostics errors;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const ObjectOptions& config = objects[i];
    const std::vector<ObjectVariant>& all = variants[i].all();
    Object& object = objects_.emplace_back(all.size());
    for (std::size_t k = 0; k < object.size(); ++k) {
      const bool may_differ = i < changes_O.size() && k < changes_O[i].size();
      object[k].given = givenShape(config, static_cast<int>(i) + 1,
                                   may_differ ? changes_O[i][k] : PointChange(), all[k].scale);
      object[k].links = label::linksOfVariant(i, k, world.links());
      if (!config.takes_part && !config.is_distractor) {
        leaveOutShape(object[k].given, config);
      } else if (!errors.attempt([&] { object[k] = measure(object[k], config); })) {
        break;  // the others would likely have the same errors
      }
    }
  }
  errors.throwIfAny();
}

/// @throws ErrorList if the parameters need something that the model lacks
ObjectShapes::Variant ObjectShapes::measure(Variant variant, const ObjectOptions& config) const {
  base::Diagnostics errors;
  const std::vector<const world::Link*> own = label::linksAt(variant.links, world_.links());
  variant.geometry = world::ModelGeometry(own);
  const bool is_seen = !variant.geometry.isEmpty();
  if (config.bounding_shape_O.empty() && !is_seen) {
    needVisuals(config, "bounding_shape", "model_box", errors);
  }
  if (config.farthest_points > 0 && !is_seen) {
    needVisuals(config, "keypoints", "farthest_points", errors);
  } else if (config.farthest_points > 0) {
    errors.attempt([&] {
      base::namingPlace(config.name + "/keypoints", [&] {
        variant.keypoints = world::farthestPoints(own, config.farthest_points);
      });
    });
  }
  errors.throwIfAny();
  std::vector<Pose> X_OL;
  for (const world::Link* link : own) X_OL.push_back(link->X_ML);
  variant.box_at_rest_O =
      boxAround(is_seen ? variant.geometry.box(X_OL) : variant.given.bounding_shape_O);
  return variant;
}

std::vector<Cuboid> ObjectShapes::boxesAtRest(std::size_t object) const {
  std::vector<Cuboid> boxes;
  for (const Variant& variant : objects_[object]) boxes.push_back(variant.box_at_rest_O);
  return boxes;
}

std::vector<label::ObjectShape> ObjectShapes::at(
    const std::vector<std::optional<Pose>>& X_WO) const {
  std::vector<label::ObjectShape> shapes;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    shapes.push_back(shapeOf(objects_[i][world_.variant(i)], X_WO[i]));
  }
  return shapes;
}

label::ObjectShape ObjectShapes::shapeOf(const Variant& variant,
                                         const std::optional<Pose>& X_WO) const {
  label::ObjectShape shape = variant.given;
  std::optional<Pose> X_OW;
  if (X_WO) X_OW = X_WO->inverse();
  std::vector<Pose> X_OL;
  for (const std::size_t link : variant.links) {
    X_OL.push_back(X_OW ? *X_OW * world_.linkPoses()[link] : world_.links()[link].link->X_ML);
  }
  const bool is_seen = !variant.geometry.isEmpty();
  if (is_seen && shape.bounding_shape_O.empty()) {
    shape.bounding_shape_O = variant.geometry.box(X_OL);
  }
  shape.cuboid_O = boxAround(is_seen ? variant.geometry.box(X_OL) : shape.bounding_shape_O);
  for (const world::SurfacePoint& point : variant.keypoints) {
    shape.keypoints_O.push_back(X_OL[point.link] * point.p_L);
  }
  return shape;
}

}  // namespace synthetic_dataset::scene
