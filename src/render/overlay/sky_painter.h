#pragma once

#include <vector>

#include <opencv2/core/types.hpp>

#include "render/gl/rectangle_drawing.h"
#include "render/gl/shader_program.h"
#include "render/view.h"
#include "world/description.h"

namespace synthetic_dataset::render {

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

}  // namespace synthetic_dataset::render
