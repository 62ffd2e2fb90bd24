#include "run/live/object_portrait.h"

#include <algorithm>

#include "run/live/json_values.h"
#include "run/pictures/model_portrait.h"
#include "synthetic_dataset/errors.h"
#include "world/physics/ray_caster.h"

namespace synthetic_dataset::run {
namespace {

constexpr int kNarrowest = 64;  // [px]
constexpr int kWidest = 2048;   // [px]

/// An object's first model at rest, with its frame as the world frame, and the view of it.
class Studio {
 public:
  Studio(const MotionSetup& motion, std::size_t object, const Viewpoint& viewpoint)
      : size_(sizeOf(viewpoint)), ahead_O_(directionFrom(viewpoint.yaw, viewpoint.pitch)) {
    world::Model model;
    model.name = motion.config.objects[object].name;
    for (const world::LinkInstance& each : motion.world->links()) {
      const bool is_of_it = each.object == static_cast<int>(object) && each.variant == 0;
      if (!is_of_it) continue;
      model.links.push_back(*each.link);
      links_.push_back(each);
      X_OL_.push_back(each.link->X_ML);
    }
    alone_.models.push_back(std::move(model));
    bounds_O_ = visibleBounds(alone_);
    if (bounds_O_.isEmpty()) {
      throw Error("'" + alone_.models.front().name + "': nothing of its model can be seen");
    }
  }

  [[nodiscard]] cv::Mat picture() const { return portray(alone_, size_, ahead_O_); }
  [[nodiscard]] render::View view() const { return portraitView(bounds_O_, size_, ahead_O_); }
  [[nodiscard]] const Eigen::AlignedBox3d& bounds() const { return bounds_O_; }
  [[nodiscard]] const std::vector<world::LinkInstance>& links() const { return links_; }
  [[nodiscard]] world::RayCaster rays() const { return {links_, X_OL_}; }

 private:
  static cv::Size sizeOf(const Viewpoint& viewpoint) {
    const int width = std::clamp(viewpoint.width, kNarrowest, kWidest);
    return {width, width * 3 / 4};
  }

  cv::Size size_;
  Eigen::Vector3d ahead_O_;
  world::Description alone_;
  std::vector<world::LinkInstance> links_;
  std::vector<Pose> X_OL_;
  Eigen::AlignedBox3d bounds_O_;
};

}  // namespace

ObjectPortrait portrayObject(const MotionSetup& motion, std::size_t object,
                             const Viewpoint& viewpoint) {
  const Studio studio(motion, object, viewpoint);
  ObjectPortrait portrait{studio.picture(), {}, {studio.bounds().min(), studio.bounds().max()}};
  const render::View view = studio.view();
  const Pose X_CO = view.X_WC.inverse();
  const world::RayCaster rays = studio.rays();
  const double near = 0.01 * studio.bounds().diagonal().norm();  // [m]: on a rough surface
  for (const Eigen::Vector3d& p_O : motion.config.objects[object].keypoints_O) {
    const auto pixel = view.camera.project(X_CO * p_O);
    if (!pixel) continue;
    const Eigen::Vector3d to_point = p_O - view.X_WC.translation();
    const auto hit = rays.cast(view.X_WC.translation(), to_point, to_point.norm());
    portrait.keypoints.push_back({*pixel, !hit || hit->distance > to_point.norm() - near});
  }
  return portrait;
}

std::optional<PickedPoint> pickPoint(const MotionSetup& motion, std::size_t object,
                                     const Viewpoint& viewpoint, const Eigen::Vector2d& pixel) {
  const Studio studio(motion, object, viewpoint);
  const render::View view = studio.view();
  const auto ray_C = view.camera.ray(pixel);
  if (!ray_C) return std::nullopt;
  const Eigen::Vector3d eye_O = view.X_WC.translation();
  const Eigen::Vector3d ray_O = (view.X_WC.linear() * *ray_C).normalized();
  const auto hit = studio.rays().cast(eye_O, ray_O, view.camera.far());
  if (!hit) return std::nullopt;
  return PickedPoint{studio.links()[hit->link].link->name, eye_O + hit->distance * ray_O};
}

Value::Map portraitValue(const ObjectPortrait& portrait) {
  Value::List keypoints;
  for (const PortraitPoint& each : portrait.keypoints) {
    keypoints.emplace_back(Value::List{each.pixel.x(), each.pixel.y(), each.is_visible});
  }
  return {{"width", portrait.picture.cols},
          {"height", portrait.picture.rows},
          {"keypoints", keypoints},
          {"low", pointValue(portrait.box_O.low)},
          {"high", pointValue(portrait.box_O.high)}};
}

}  // namespace synthetic_dataset::run
