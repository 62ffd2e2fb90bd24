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

/// The macros about the lights with which shaders that include lighting.glsl are compiled, among
/// them EACH_LIGHT.
/// @param chosen  the indices of the lights that the shaders use
/// @param detail  the highest for which these shaders are used
[[nodiscard]] std::string lightMacros(const std::vector<world::Light>& lights,
                                      const std::vector<std::size_t>& chosen, LightDetail detail);

/// A light as a camera sees it, in its optical frame.
struct LightInView {
  world::LightType type;
  Eigen::Vector3f position_C;
  Eigen::Vector3f direction_C;  ///< in which it shines
  Eigen::Vector3f intensity;
  Eigen::Vector3f specular;     ///< for highlights in Gazebo Classic
  Eigen::Vector3f attenuation;  ///< constant, linear, quadratic
  float range;                  ///< [m]
  Eigen::Vector3f cone;         ///< cosine of the inner angle, cosine of the outer angle, falloff
};

[[nodiscard]] std::vector<LightInView> lightsIn(const View& view,
                                                const std::vector<world::Light>& lights);

/// The world's up direction, in the camera's optical frame.
[[nodiscard]] Eigen::Vector3f upIn(const View& view);

/// Sets the uniforms for the lights in such a shader, in the camera's frame.
/// @param chosen  the indices for which it was compiled
void setLights(const ShaderProgram& program, const std::vector<world::Light>& lights,
               const std::vector<std::size_t>& chosen, const std::vector<ShadowProjection>& shadows,
               const View& view);

}  // namespace synthetic_dataset::render
