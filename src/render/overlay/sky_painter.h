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

/// The unit vector towards the sun.
///
/// By day it is where the first directional light comes from, so that shadows agree with the sky;
/// without such a light, and at night, it follows the time: it rises in the east (+x), is highest
/// in the south (-y) at 60 degrees, and sets in the west.
[[nodiscard]] Eigen::Vector3d sunDirection(const world::Sky& sky,
                                           const std::vector<world::Light>& lights);

/// The program of sky.frag, with every uniform that is constant for a sky set.
/// @param macros  lines to insert at its beginning
[[nodiscard]] ShaderProgram makeSkyProgram(const GlFunctions& gl, const world::Sky& sky,
                                           const std::string& macros);

/// Sets the position of the sun in such a program.
/// @param sun  as from sunDirection()
void setSun(const ShaderProgram& program, const Eigen::Vector3d& sun);

/// Paints the sky where nothing is drawn. For given lights, what it paints depends on the view and
/// the exposure only.
class SkyPainter {
 public:
  /// @param encoded  whether what is painted is encoded and exposed later (shown.glsl)
  SkyPainter(const GlFunctions& gl, const world::Sky& sky, const std::vector<world::Light>& lights,
             bool encoded);

  /// Places the sun according to the lights, as sunDirection() does.
  void setLights(const std::vector<world::Light>& lights) const;

  /// Fills the pixels of the bound target that are still at the far plane.
  /// @param exposure  multiplies the sky's light
  /// @param regions  of the picture; only these are painted
  void paint(const View& view, float exposure, const std::vector<cv::Rect>& regions) const;

 private:
  world::Sky sky_;
  ShaderProgram program_;
  RectangleDrawing drawing_;
};

/// Draws the whole sky as linear light, with the program that paints it, but without the sun.
class SkyPanorama {
 public:
  SkyPanorama(const GlFunctions& gl, const world::Sky& sky);

  /// @param sun  as from sunDirection()
  /// @return a panorama in the form that PanoramaLight takes
  [[nodiscard]] cv::Mat draw(const Eigen::Vector3d& sun) const;

 private:
  ShaderProgram program_;
  RectangleDrawing drawing_;
  Framebuffer light_;
};

}  // namespace synthetic_dataset::render
