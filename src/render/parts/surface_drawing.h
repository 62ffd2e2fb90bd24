#pragma once

#include "render/gl/gl_functions.h"
#include "render/gl/shader_program.h"
#include "render/parts/draw_list.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// The share of light that a dielectric reflects at normal incidence, from the strength of its
/// specular colour (Lagarde and de Rousiers 2014, "Moving Frostbite to PBR": 0.16 r^2).
[[nodiscard]] float reflectance(const world::Material& material);

/// Sets a program's uniforms for an item's material, and binds its textures except the diffuse one.
/// @param simulator  for Gazebo Classic, the diffuse colour is in ClassicLight instead
void setMaterial(const GlFunctions& gl, const ShaderProgram& program, const DrawItem& item,
                 world::Simulator simulator);

/// Binds the diffuse texture, which determines holes, and sets its placement and threshold: the
/// part of a material that every pass needs.
void bindHoles(const GlFunctions& gl, const ShaderProgram& program, const DrawItem& item);

/// The features that a view requires of all surfaces' programs.
[[nodiscard]] SurfaceFeatures featuresOf(const View& view);

/// Draws an item as the camera sees it, with a program whose vertex stage is mesh.vert and which
/// has the view's features.
/// @param X_WL  of the item's link
void drawSurface(const GlFunctions& gl, const ShaderProgram& program, const DrawItem& item,
                 const View& view, const Pose& X_WL);

}  // namespace synthetic_dataset::render
