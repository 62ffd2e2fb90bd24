#pragma once

#include <vector>

#include <opencv2/core/types.hpp>

#include "render/gl/gl_object.h"
#include "render/gl/shader_program.h"

namespace synthetic_dataset::render {

/// Draws rectangles of a picture with programs whose vertex shader is rectangles.vert.
class RectangleDrawing {
 public:
  explicit RectangleDrawing(const GlFunctions& gl) : gl_(gl), no_vertices_(makeVertexArray(gl)) {}

  /// @param picture  the size of the whole picture
  void draw(const ShaderProgram& program, const std::vector<cv::Rect>& rectangles,
            const cv::Size& picture) const;

 private:
  const GlFunctions& gl_;
  GlVertexArray no_vertices_;
};

}  // namespace synthetic_dataset::render
