#include "render/shadows/shadow_projection.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace synthetic_dataset::render {
namespace {

constexpr int kMaxShadows = SYNTHETIC_DATASET_MAX_SHADOWS;

bool castsShadow(const world::Light& light) {
  // A point light would need a map for each of six directions.
  return light.casts_shadow && light.type != world::LightType::kPoint;
}

/// World from a frame whose +z is where the light shines.
Pose lightFrame(const world::Light& light) {
  const Eigen::Vector3d direction = (light.X_WL.linear() * light.direction_L).normalized();
  Pose X_WS = Pose::Identity();
  X_WS.linear() =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), direction).toRotationMatrix();
  X_WS.translation() = light.X_WL.translation();
  return X_WS;
}

/// The corners of what the camera sees up to `distance`.
std::vector<Eigen::Vector3d> viewCorners(const View& view, double distance) {
  const Box image = view.camera.imageBounds();
  const Intrinsics& k = view.camera.intrinsics();
  const double far = std::max(std::min(view.camera.far(), distance), 2.0 * view.camera.near());
  std::vector<Eigen::Vector3d> corners;
  for (const double z : {view.camera.near(), far}) {
    for (const double u : {image.left, image.right}) {
      for (const double v : {image.top, image.bottom}) {
        corners.emplace_back(view.X_WC *
                             Eigen::Vector3d((u - k.cx) / k.fx * z, (v - k.cy) / k.fy * z, z));
      }
    }
  }
  return corners;
}

Bounds boundsIn(const Pose& X_SW, const std::vector<Eigen::Vector3d>& points_W) {
  Bounds bounds;
  for (const Eigen::Vector3d& point : points_W) bounds.extend(X_SW * point);
  return bounds;
}

/// Parallel light: the map covers what is both seen and near something that casts.
void fitDirectional(const world::Light& light, const std::vector<View>& views,
                    const Bounds& casters, double shadow_distance, int size,
                    ShadowProjection& projection) {
  constexpr double kMargin = 0.02;  // of the casters' depth, so that none lies on the map's border
  const Pose X_SW = lightFrame(light).inverse();
  const Bounds casting = boundsIn(X_SW, cornersOf(casters));
  Bounds seen;
  for (const View& view : views) seen.extend(boundsIn(X_SW, viewCorners(view, shadow_distance)));
  Eigen::Vector3d low = casting.min().cwiseMax(seen.min());
  Eigen::Vector3d high = casting.max().cwiseMin(seen.max());
  if (low.x() >= high.x() || low.y() >= high.y()) {  // nothing that casts is near what is seen
    low = casting.min();
    high = casting.max();
  }
  const double depth = std::max(casting.max().z() - casting.min().z(), 1e-3);
  const double nearest = casting.min().z() - kMargin * depth;
  const double range = (1.0 + 2.0 * kMargin) * depth;
  const Eigen::Vector2d extent = (high - low).head<2>().cwiseMax(1e-3);
  const Eigen::Vector2d middle = 0.5 * (low + high).head<2>();
  Eigen::Matrix4d clip_from_light = Eigen::Matrix4d::Identity();
  clip_from_light(0, 0) = 2.0 / extent.x();
  clip_from_light(1, 1) = 2.0 / extent.y();
  clip_from_light(0, 3) = -2.0 * middle.x() / extent.x();
  clip_from_light(1, 3) = -2.0 * middle.y() / extent.y();
  clip_from_light(2, 2) = 1.0 / range;
  clip_from_light(2, 3) = -nearest / range;
  projection.shadow_from_world = clip_from_light * X_SW.matrix();
  projection.texel = extent.maxCoeff() / size;
}

/// A spot light's map is what the light sees within its outer angle.
void fitSpot(const world::Light& light, int size, ShadowProjection& projection) {
  constexpr double kNear = 0.05;                 // [m] things nearer to the light cast nothing
  constexpr double kWidest = 0.48 * 3.14159265;  // [rad] half angle; a plane cannot hold more
  const double half_angle = std::clamp(0.5 * light.spot_outer_angle, 0.01, kWidest);
  const double far = std::max(light.range, 2.0 * kNear);
  const double scale = 1.0 / std::tan(half_angle);
  Eigen::Matrix4d clip_from_light = Eigen::Matrix4d::Zero();
  clip_from_light(0, 0) = scale;
  clip_from_light(1, 1) = scale;
  clip_from_light(2, 2) = far / (far - kNear);
  clip_from_light(2, 3) = -far * kNear / (far - kNear);
  clip_from_light(3, 2) = 1.0;
  projection.shadow_from_world = clip_from_light * lightFrame(light).inverse().matrix();
  projection.texel = 2.0 / (scale * size);
}

}  // namespace

std::vector<int> shadowLayers(const std::vector<world::Light>& lights) {
  int next = 0;
  std::vector<int> layers;
  for (const world::Light& light : lights) {
    layers.push_back(castsShadow(light) && next < kMaxShadows ? next++ : -1);
  }
  return layers;
}

int shadowCount(const std::vector<world::Light>& lights) {
  const auto count = std::count_if(lights.begin(), lights.end(), castsShadow);
  return std::min(static_cast<int>(count), kMaxShadows);
}

std::vector<std::string> shadowNotes(const std::vector<world::Light>& lights) {
  std::vector<std::string> notes;
  int casting = 0;
  for (const world::Light& light : lights) {
    if (!light.casts_shadow) continue;
    if (light.type == world::LightType::kPoint) {
      notes.push_back("light '" + light.name +
                      "' casts no shadow: only directional and spot lights do");
    } else if (++casting > kMaxShadows) {
      notes.push_back("light '" + light.name + "' casts no shadow: only the first " +
                      std::to_string(kMaxShadows) + " lights with <cast_shadows> do");
    }
  }
  return notes;
}

std::vector<ShadowProjection> shadowProjections(const std::vector<world::Light>& lights,
                                                const std::vector<View>& views,
                                                const Bounds& casters, double shadow_distance,
                                                int size) {
  std::vector<ShadowProjection> result;
  if (casters.isEmpty()) return result;
  const std::vector<int> layers = shadowLayers(lights);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (layers[i] < 0) continue;
    ShadowProjection projection;
    projection.light = static_cast<int>(i);
    projection.layer = layers[i];
    if (lights[i].type == world::LightType::kSpot) {
      fitSpot(lights[i], size, projection);
    } else {
      fitDirectional(lights[i], views, casters, shadow_distance, size, projection);
    }
    result.push_back(projection);
  }
  return result;
}

}  // namespace synthetic_dataset::render
