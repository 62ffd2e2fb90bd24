#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "render/gl/gl_object.h"
#include "render/gl/rectangle_drawing.h"
#include "render/gl/shader_program.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// Draws all of a sky, as the light that it is: by the program that paints it, but without the sun.
class SkyPanorama {
 public:
  SkyPanorama(const GlFunctions& gl, const world::Sky& sky);

  /// @param sun  as of sunDirection()
  /// @return as PanoramaLight takes it
  [[nodiscard]] cv::Mat draw(const Eigen::Vector3d& sun) const;

 private:
  const GlFunctions& gl_;
  ShaderProgram program_;
  RectangleDrawing drawing_;
  cv::Size size_;
  GlTexture light_;
  GlFramebuffer framebuffer_;
};

}  // namespace synthetic_dataset::render
