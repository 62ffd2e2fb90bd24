#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "render/bounds.h"
#include "render/shader_program.h"
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
/// @param casters  in the world, round all that casts shadows; nothing casts where it is empty
/// @param shadow_distance  from the camera up to which directional shadows are drawn [m]
/// @param size  of a map's side [texel]
[[nodiscard]] std::vector<ShadowProjection> shadowProjections(
    const std::vector<world::Light>& lights, const std::vector<View>& views, const Bounds& casters,
    double shadow_distance, int size);

/// How many shadow maps these lights take, at most as many as the shader has.
[[nodiscard]] int shadowCount(const std::vector<world::Light>& lights);

/// What the user should know: which lights should cast shadows and do not.
[[nodiscard]] std::vector<std::string> shadowNotes(const std::vector<world::Light>& lights);

/// @throws Error when there are more lights than the shader has
void checkLightCount(const std::vector<world::Light>& lights);

/// What shaders with lighting.glsl have to know of the lights when they are compiled: their macro
/// EACH_LIGHT.
[[nodiscard]] std::string lightMacros(const std::vector<world::Light>& lights);

/// A light as a camera sees it, in its optical frame.
struct LightInView {
  world::LightType type;
  Eigen::Vector3f position_C;
  Eigen::Vector3f direction_C;  ///< where it shines
  Eigen::Vector3f intensity;
  Eigen::Vector3f attenuation;  ///< constant, linear, quadratic
  float range;                  ///< [m]
  Eigen::Vector3f cone;         ///< cosine of the inner angle, cosine of the outer angle, falloff
};

[[nodiscard]] std::vector<LightInView> lightsIn(const View& view,
                                                const std::vector<world::Light>& lights);

/// The world's upwards, in the camera's optical frame.
[[nodiscard]] Eigen::Vector3f upIn(const View& view);

/// Tells such a shader of the lights, in the camera's frame.
void setLights(const ShaderProgram& program, const std::vector<world::Light>& lights,
               const std::vector<ShadowProjection>& shadows, const View& view);

}  // namespace synthetic_dataset::render
