#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "render/gl/shader_program.h"
#include "render/shadows/shadow_projection.h"
#include "render/view.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// What shaders with lighting.glsl have to know of the lights when they are compiled: their macro
/// EACH_LIGHT.
/// @param chosen  the lights that they are for, by their indices
/// @param detail  the most that these shaders are used for
[[nodiscard]] std::string lightMacros(const std::vector<world::Light>& lights,
                                      const std::vector<std::size_t>& chosen, LightDetail detail);

/// A light as a camera sees it, in its optical frame.
struct LightInView {
  world::LightType type;
  Eigen::Vector3f position_C;
  Eigen::Vector3f direction_C;  ///< where it shines
  Eigen::Vector3f intensity;
  Eigen::Vector3f specular;     ///< of highlights in Gazebo Classic
  Eigen::Vector3f attenuation;  ///< constant, linear, quadratic
  float range;                  ///< [m]
  Eigen::Vector3f cone;         ///< cosine of the inner angle, cosine of the outer angle, falloff
};

[[nodiscard]] std::vector<LightInView> lightsIn(const View& view,
                                                const std::vector<world::Light>& lights);

/// The world's upwards, in the camera's optical frame.
[[nodiscard]] Eigen::Vector3f upIn(const View& view);

/// Tells such a shader of the lights, in the camera's frame.
/// @param chosen  those that it was compiled for
void setLights(const ShaderProgram& program, const std::vector<world::Light>& lights,
               const std::vector<std::size_t>& chosen, const std::vector<ShadowProjection>& shadows,
               const View& view);

}  // namespace synthetic_dataset::render
