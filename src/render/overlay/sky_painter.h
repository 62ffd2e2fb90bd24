#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include "render/gl/framebuffer.h"
#include "render/gl/gl_object.h"
#include "render/gl/rectangle_drawing.h"
#include "render/gl/shader_program.h"
#include "render/view.h"
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

/// Paints the sky where nothing is drawn. What it paints depends on the view alone.
class SkyPainter {
 public:
  /// @param encoded  whether what is painted is encoded and exposed later (shown.glsl)
  SkyPainter(const GlFunctions& gl, const world::Sky& sky, const std::vector<world::Light>& lights,
             bool encoded);

  /// The sun stands where the first directional light comes from.
  void setLights(const std::vector<world::Light>& lights) const;

  /// Fills the pixels of the bound target that are still at the far plane.
  /// @param exposure  multiplies its light
  /// @param regions  of the picture, the only ones that are painted
  void paint(const View& view, float exposure, const std::vector<cv::Rect>& regions) const;

 private:
  world::Sky sky_;
  ShaderProgram program_;
  RectangleDrawing drawing_;
};

/// Draws all of a sky, as the light that it is: by the program that paints it, but without the sun.
class SkyPanorama {
 public:
  SkyPanorama(const GlFunctions& gl, const world::Sky& sky);

  /// @param sun  as of sunDirection()
  /// @return as PanoramaLight takes it
  [[nodiscard]] cv::Mat draw(const Eigen::Vector3d& sun) const;

 private:
  ShaderProgram program_;
  RectangleDrawing drawing_;
  Framebuffer light_;
};

}  // namespace synthetic_dataset::render
