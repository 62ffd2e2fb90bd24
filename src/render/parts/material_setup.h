#pragma once

#include "render/gl/gl_functions.h"
#include "render/gl/shader_program.h"
#include "render/parts/draw_list.h"

namespace synthetic_dataset::render {

/// The light that a dielectric throws back head-on, from the strength of its specular colour
/// (Lagarde and de Rousiers 2014, "Moving Frostbite to PBR": 0.16 r^2).
[[nodiscard]] float reflectance(const world::Material& material);

/// Tells a program what an item is made of, and binds its pictures but the diffuse one.
/// @param simulator  Gazebo Classic's light has the diffuse colour elsewhere (ClassicLight)
void setMaterial(const GlFunctions& gl, const ShaderProgram& program, const DrawItem& item,
                 world::Simulator simulator);

}  // namespace synthetic_dataset::render
