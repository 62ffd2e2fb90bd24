#pragma once

#include "render/gl/gl_functions.h"
#include "render/gl/shader_program.h"
#include "render/parts/draw_list.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// The light that a dielectric throws back head-on, from the strength of its specular colour
/// (Lagarde and de Rousiers 2014, "Moving Frostbite to PBR": 0.16 r^2).
[[nodiscard]] float reflectance(const world::Material& material);

/// Tells a program what an item is made of, and binds its pictures but the diffuse one.
/// @param simulator  Gazebo Classic's light has the diffuse colour elsewhere (ClassicLight)
void setMaterial(const GlFunctions& gl, const ShaderProgram& program, const DrawItem& item,
                 world::Simulator simulator);

/// Tells a program of the picture with the holes, and where it lies: all that every pass has to
/// know of a material.
void bindHoles(const GlFunctions& gl, const ShaderProgram& program, const DrawItem& item);

/// What a view asks of the programs of all surfaces.
[[nodiscard]] SurfaceFeatures featuresOf(const View& view);

/// Draws an item as the camera sees it, with a program whose vertex stage is mesh.vert
/// and which has the view's features.
/// @param X_WL  of the item's link
void drawSurface(const GlFunctions& gl, const ShaderProgram& program, const DrawItem& item,
                 const View& view, const Pose& X_WL);

}  // namespace synthetic_dataset::render
