#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "render/parts/bounds.h"
#include "render/view.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// How far above itself a surface is compared with a shadow map, in sizes of a texel: this much,
/// and this much more where light grazes it.
inline constexpr double kShadowRaise = 0.6;
inline constexpr double kGrazingShadowRaise = 2.2;

/// How one light's shadow map is made and read.
struct ShadowProjection {
  int light = 0;  ///< index in the description's lights
  int layer = 0;
  Eigen::Matrix4d shadow_from_world = Eigen::Matrix4d::Identity();
  double texel = 0.0;  ///< a texel's size [m], for spot lights at a distance of 1 m
};

/// The lights that cast shadows, each with a projection that holds what the views may see shaded.
/// @param views  those that are put together to one picture, so that they share its shadows
/// @param casters  in the world, around all that casts shadows; nothing casts where it is empty
/// @param shadow_distance  from the camera up to which directional shadows are drawn [m]
/// @param size  of a map's side [texel]
[[nodiscard]] std::vector<ShadowProjection> shadowProjections(
    const std::vector<world::Light>& lights, const std::vector<View>& views, const Bounds& casters,
    double shadow_distance, int size);

/// How many shadow maps these lights take, at most as many as the shader has.
[[nodiscard]] int shadowCount(const std::vector<world::Light>& lights);

/// What the user should know: which lights should cast shadows and do not.
[[nodiscard]] std::vector<std::string> shadowNotes(const std::vector<world::Light>& lights);

/// The layer of each light's shadow map, -1 for those that cast none.
[[nodiscard]] std::vector<int> shadowLayers(const std::vector<world::Light>& lights);

}  // namespace synthetic_dataset::render
