#pragma once

#include <opencv2/core/mat.hpp>

#include "render/geometry/geometry_buffer.h"
#include "render/gl/gl_object.h"

namespace synthetic_dataset::render {

/// Where what is behind and before the surfaces of a picture is drawn, linear: its light, and as
/// alpha how much of theirs passes.
class OverlayTarget {
 public:
  /// @param geometry  the surfaces, for their depth; has to outlive this
  OverlayTarget(const GlFunctions& gl, int width, int height, const GeometryBuffer& geometry);

  /// Binds it, and empties these pixels: nothing is drawn beside them.
  void begin(const cv::Rect& pixels) const;

  /// Ends what begin() began.
  /// @return CV_16UC4 of the pixels: red, green, blue, alpha, numbers of 16 bits
  [[nodiscard]] cv::Mat read(const cv::Rect& pixels) const;

 private:
  const GlFunctions& gl_;
  int width_;
  int height_;
  GlTexture light_;
  GlFramebuffer framebuffer_;
};

}  // namespace synthetic_dataset::render
