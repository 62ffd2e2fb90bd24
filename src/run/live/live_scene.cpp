#include "run/live/live_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "plugins/shared/colour_map.h"
#include "plugins/shared/mask_outlines.h"
#include "run/live/json_values.h"

namespace synthetic_dataset::run {
namespace {

Value boxValue(const std::optional<Box>& box) {
  if (!box) return {};
  return numbersValue({box->left, box->top, box->width(), box->height()});
}

/// The rings follow pixel edges, in coordinates in which the image spans 0 to its width.
Value polygonsValue(const Mask& mask) {
  Value::List polygons;
  for (const masks::Ring& ring : masks::edgeRings(mask)) {
    Value::List points;
    for (const cv::Point& point : ring)
      points.push_back(numbersValue({point.x - 0.5, point.y - 0.5}));
    polygons.emplace_back(std::move(points));
  }
  return polygons;
}

Value pixelValue(const std::optional<Eigen::Vector2d>& pixel) {
  if (!pixel) return {};
  return numbersValue({pixel->x(), pixel->y()});
}

Value keypointValue(const Keypoint& keypoint) {
  if (!keypoint.pixel) return {};
  Value::List values = {Value(keypoint.pixel->x()), Value(keypoint.pixel->y()),
                        Value(keypoint.state() == KeypointState::kVisible)};
  return values;
}

/// @param X_CO  nothing: the points have no pixels
template <class Points>
Value projectedValue(const Points& points_O, const std::optional<Pose>& X_CO,
                     const CameraModel& camera) {
  Value::List pixels;
  for (const Eigen::Vector3d& p_O : points_O)
    pixels.push_back(X_CO ? pixelValue(camera.project(*X_CO * p_O)) : Value());
  return pixels;
}

Value objectValue(const SceneObject& object, const CameraModel& camera) {
  Value::List keypoints;
  for (const Keypoint& each : object.keypoints) keypoints.push_back(keypointValue(each));
  return Value::Map{
      {"name", object.name},
      {"class", object.class_name},
      {"labelled", object.labelled()},
      {"visible", object.pixels.visible()},
      {"visibility", object.visibility()},
      {"truncation", object.truncation()},
      {"box", boxValue(object.visibleBox())},
      {"amodal_box", boxValue(object.silhouette_box())},
      {"loose_box", boxValue(object.loose_box)},
      {"polygons", polygonsValue(object.visible_mask())},
      {"keypoints", keypoints},
      {"cuboid", projectedValue(object.cuboid_O.corners(), object.X_CO, camera)},
      {"bounding_shape", projectedValue(object.bounding_shape_O, object.X_CO, camera)},
      {"distance", object.X_CO ? Value(object.distance()) : Value()},
      {"pose", object.X_GO ? poseValue(*object.X_GO) : Value()}};
}

Value cameraValue(const Scene& scene) {
  const Intrinsics& lens = scene.camera.intrinsics();
  return Value::Map{{"name", scene.camera_name},
                    {"width", scene.camera.width()},
                    {"height", scene.camera.height()},
                    {"intrinsics", numbersValue({lens.fx, lens.fy, lens.cx, lens.cy})},
                    {"pose", poseValue(scene.X_GC)}};
}

}  // namespace

Value drawsValue(const LiveDraw& draw) {
  Value::Map draws;
  for (const base::DrawFacts& each : draw.draws) draws[each.name] = each.value;
  return draws;
}

Value::Map sceneValue(const LiveScene& live) {
  const Scene& scene = live.scene;
  Value::List objects;
  for (const SceneObject& each : scene.objects) objects.push_back(objectValue(each, scene.camera));
  return {{"instant", scene.instant},
          {"name", scene.name},
          {"split", scene.split},
          {"stamp", toSeconds(scene.stamp)},
          {"camera", cameraValue(scene)},
          {"labels", Value::Map{{"objects", objects}}},
          {"milliseconds", 1000.0 * live.seconds},
          {"processor_milliseconds", 1000.0 * live.processor_seconds}};
}

cv::Mat depthPicture(const cv::Mat& depth) {
  // Brightness is linear in 1 / z, which matches how finely depth is perceived and is not darkened
  // by far walls.
  float nearest = std::numeric_limits<float>::max();
  for (auto z = depth.begin<float>(); z != depth.end<float>(); ++z) {
    if (*z > 0.0F) nearest = std::min(nearest, *z);
  }
  cv::Mat grey(depth.size(), CV_8UC1, cv::Scalar(0));
  for (int y = 0; y < depth.rows; ++y) {
    const auto* z = depth.ptr<float>(y);
    auto* to = grey.ptr<std::uint8_t>(y);
    for (int x = 0; x < depth.cols; ++x) {
      if (z[x] > 0.0F) to[x] = cv::saturate_cast<std::uint8_t>(1.0F + 254.0F * nearest / z[x]);
    }
  }
  cv::Mat picture;
  cv::applyColorMap(grey, picture, cv::COLORMAP_TURBO);
  picture.setTo(cv::Scalar::all(0), grey == 0);
  return picture;
}

cv::Mat instancePicture(const cv::Mat& instance_map) {
  const std::vector<cv::Vec3b> colours = vocColourMap();
  cv::Mat picture(instance_map.size(), CV_8UC3, cv::Scalar::all(0));
  for (int y = 0; y < instance_map.rows; ++y) {
    const auto* instance = instance_map.ptr<std::uint16_t>(y);
    auto* to = picture.ptr<cv::Vec3b>(y);
    for (int x = 0; x < instance_map.cols; ++x) {
      if (instance[x] > 0) to[x] = colours[1 + (instance[x] - 1U) % (colours.size() - 1)];
    }
  }
  return picture;
}

}  // namespace synthetic_dataset::run
