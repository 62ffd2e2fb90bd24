#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "render/gl/shader_program.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// Where the sun stands: the unit vector towards it.
///
/// By day it is where the first directional light comes from, so that shadows agree with the sky;
/// without such a light, and at night, it follows the time: up at sunrise in the east (+x), at its
/// highest in the south (-y) at 60 degrees, down at sunset in the west.
[[nodiscard]] Eigen::Vector3d sunDirection(const world::Sky& sky,
                                           const std::vector<world::Light>& lights);

/// sky.frag with all that stays the same of a sky.
/// @param macros  lines before it
[[nodiscard]] ShaderProgram makeSkyProgram(const GlFunctions& gl, const world::Sky& sky,
                                           const std::string& macros);

/// Tells such a program where the sun stands.
/// @param sun  as of sunDirection()
void setSun(const ShaderProgram& program, const Eigen::Vector3d& sun);

}  // namespace synthetic_dataset::render
