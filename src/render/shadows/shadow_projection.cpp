#include "render/shadows/shadow_projection.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>

namespace synthetic_dataset::render {
namespace {

/// The tangent of half the sun's angular diameter, which is 0.53 degrees.
constexpr double kSunRadius = 0.004625;

/// The radius of spot and point lights [m], for which SDF has no setting.
constexpr double kBulbRadius = 0.03;

bool castsShadow(const world::Light& light, LightDetail detail) {
  // In Gazebo's worlds, OGRE draws no shadows of point lights.
  return light.casts_shadow &&
         (light.type != world::LightType::kPoint || detail == LightDetail::kFull);
}

/// The maximum number of lights that cast shadows; their maps share the texels of a few.
constexpr std::size_t kMostCasting = 32;

/// A measure of how large a part of a world a light illuminates, and how brightly.
double strengthOf(const world::Light& light) {
  if (light.type == world::LightType::kDirectional) return std::numeric_limits<double>::infinity();
  return light.diffuse.maxCoeff() * light.range * light.range;
}

/// For each light, whether it casts a shadow.
std::vector<bool> castingLights(const std::vector<world::Light>& lights, LightDetail detail) {
  std::vector<world::Light> casting;
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (!castsShadow(lights[i], detail)) continue;
    casting.push_back(lights[i]);
    indices.push_back(i);
  }
  std::vector<bool> casts(lights.size(), false);
  for (const std::size_t i : strongestLights(casting, kMostCasting)) casts[indices[i]] = true;
  return casts;
}

/// A map's side length, chosen so that many maps have no more texels than a few.
int sizeOf(int size, int count) {
  constexpr double kFew = 4.0;
  if (count <= kFew) return size;
  return std::max(static_cast<int>(size * std::sqrt(kFew / count)), 1);
}

/// The pose in the world of a frame at a light whose +z axis points in a direction.
Pose frameTowards(const world::Light& light, const Eigen::Vector3d& direction) {
  Pose X_WS = Pose::Identity();
  X_WS.linear() =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), direction).toRotationMatrix();
  X_WS.translation() = light.X_WL.translation();
  return X_WS;
}

/// The pose in the world of a frame whose +z axis points where the light shines.
Pose lightFrame(const world::Light& light) {
  return frameTowards(light, (light.X_WL.linear() * light.direction_L).normalized());
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

/// For parallel light: the map covers what is both seen and within the casters' bounds.
void fitDirectional(const world::Light& light, const std::vector<View>& views,
                    const Bounds& casters, double shadow_distance, int size, LightDetail detail,
                    ShadowProjection& projection) {
  constexpr double kMargin = 0.02;  // of the casters' depth range, so that none is on its border
  const Pose X_SW = lightFrame(light).inverse();
  const Bounds casting = boundsIn(X_SW, cornersOf(casters));
  Bounds seen;
  for (const View& view : views) seen.extend(boundsIn(X_SW, viewCorners(view, shadow_distance)));
  Eigen::Vector3d low = casting.min().cwiseMax(seen.min());
  Eigen::Vector3d high = casting.max().cwiseMin(seen.max());
  if (low.x() >= high.x() || low.y() >= high.y()) {  // no caster is near what is seen
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
  projection.size = size;
  projection.texel = extent.maxCoeff() / size;
  if (detail == LightDetail::kFull) {
    projection.softness = (kSunRadius * range * size) * extent.cwiseInverse();
  }
}

/// For light from a point: the map covers what is seen from there.
/// @param scale  the inverse of the tangent of half the map's angle
void fitFromPoint(const world::Light& light, const Pose& X_WS, double scale, int size,
                  LightDetail detail, ShadowProjection& projection) {
  constexpr double kNear = 0.05;  // [m] at which depth begins
  const double far = std::max(light.range, 2.0 * kNear);
  Eigen::Matrix4d clip_from_light = Eigen::Matrix4d::Zero();
  clip_from_light(0, 0) = scale;
  clip_from_light(1, 1) = scale;
  clip_from_light(2, 2) = far / (far - kNear);
  clip_from_light(2, 3) = -far * kNear / (far - kNear);
  clip_from_light(3, 2) = 1.0;
  projection.shadow_from_world = clip_from_light * X_WS.inverse().matrix();
  projection.size = size;
  projection.texel = 2.0 / (scale * size);
  if (detail != LightDetail::kFull) return;
  // Depths differ in proportion to the inverses of distances along the axis, as does softness in
  // texels.
  const double by_inverses = far * kNear / (far - kNear);
  projection.softness.setConstant(kBulbRadius / (projection.texel * by_inverses));
}

/// For a spot light: the map covers what the light sees within its outer angle.
void fitSpot(const world::Light& light, int size, LightDetail detail,
             ShadowProjection& projection) {
  constexpr double kWidest = 0.48 * 3.14159265;  // [rad] half angle; a plane cannot hold more
  const double half_angle = std::clamp(0.5 * light.spot_outer_angle, 0.01, kWidest);
  fitFromPoint(light, lightFrame(light), 1.0 / std::tan(half_angle), size, detail, projection);
}

/// For a side of a point light's cube: the map also covers a few texels of the sides around it, as
/// far as a surface's light lookup reaches.
/// @param side  0 .. 5
void fitSide(const world::Light& light, int side, int size, ShadowProjection& projection) {
  constexpr double kRim = kWidestSoftness + 8.0;  // [texel]
  const double scale = std::max(1.0 - 2.0 * kRim / size, 0.5);
  const Eigen::Vector3d direction =
      (side < kCubeSides / 2 ? 1.0 : -1.0) * Eigen::Vector3d::Unit(side % (kCubeSides / 2));
  projection.is_side = true;
  fitFromPoint(light, frameTowards(light, direction), scale, size, LightDetail::kFull, projection);
}

}  // namespace

std::vector<std::size_t> strongestLights(const std::vector<world::Light>& lights,
                                         std::size_t most) {
  std::vector<std::size_t> strongest(lights.size());
  std::iota(strongest.begin(), strongest.end(), std::size_t{0});
  if (lights.size() <= most) return strongest;
  std::stable_sort(strongest.begin(), strongest.end(), [&](std::size_t a, std::size_t b) {
    return strengthOf(lights[a]) > strengthOf(lights[b]);
  });
  strongest.resize(most);
  std::sort(strongest.begin(), strongest.end());
  return strongest;
}

ShadowLayout shadowLayout(const std::vector<world::Light>& lights, int size, LightDetail detail) {
  ShadowLayout layout;
  const std::vector<bool> casts = castingLights(lights, detail);
  int cubes = 0;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (!casts[i]) continue;
    ++(lights[i].type == world::LightType::kPoint ? cubes : layout.maps);
  }
  layout.sides = kCubeSides * cubes;
  layout.map_size = sizeOf(size, layout.maps);
  layout.side_size = sizeOf((size + 2) / 3, cubes);
  int next_map = 0;
  int next_side = layout.maps;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    int first = -1;
    if (casts[i] && lights[i].type != world::LightType::kPoint) {
      first = next_map++;
    } else if (casts[i]) {
      first = next_side;
      next_side += kCubeSides;
    }
    layout.first_maps.push_back(first);
  }
  return layout;
}

std::vector<std::string> lightNotes(const std::vector<world::Light>& lights, LightDetail detail) {
  std::vector<std::string> notes;
  const auto casting = std::count_if(lights.begin(), lights.end(), [&](const world::Light& light) {
    return castsShadow(light, detail);
  });
  const auto noteMost = [&](std::size_t count, std::size_t most, const std::string& what) {
    if (count <= most) return;
    notes.push_back("the world has " + std::to_string(count) + " lights" + what + "; the " +
                    std::to_string(most) + " strongest do so");
  };
  noteMost(static_cast<std::size_t>(casting), kMostCasting, " that cast shadows");
  noteMost(lights.size(), kMostOnGlass, ", which light transparent surfaces");
  for (const world::Light& light : lights) {
    if (!light.casts_shadow || castsShadow(light, detail)) continue;
    notes.push_back("light '" + light.name +
                    "' casts no shadow: point lights do so only with rendering/light: full");
  }
  return notes;
}

std::vector<ShadowProjection> shadowProjections(const std::vector<world::Light>& lights,
                                                const std::vector<View>& views,
                                                const Bounds& casters, double shadow_distance,
                                                const ShadowLayout& layout, LightDetail detail) {
  std::vector<ShadowProjection> result;
  if (casters.isEmpty()) return result;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const world::Light& light = lights[i];
    if (layout.first_maps[i] < 0 || !castsShadow(light, detail)) continue;
    ShadowProjection projection;
    projection.light = static_cast<int>(i);
    projection.map = layout.first_maps[i];
    switch (light.type) {
      case world::LightType::kDirectional:
        fitDirectional(light, views, casters, shadow_distance, layout.map_size, detail, projection);
        result.push_back(projection);
        break;
      case world::LightType::kSpot:
        fitSpot(light, layout.map_size, detail, projection);
        result.push_back(projection);
        break;
      case world::LightType::kPoint:
        for (int side = 0; side < kCubeSides; ++side) {
          fitSide(light, side, layout.side_size, projection);
          result.push_back(projection);
          ++projection.map;
        }
        break;
    }
  }
  return result;
}

}  // namespace synthetic_dataset::render
