#pragma once

#include <opencv2/core/mat.hpp>

#include "render/geometry_buffer.h"
#include "render/gl_object.h"

namespace synthetic_dataset::render {

/// Where the light of each pixel is drawn, linear.
class LightTarget {
 public:
  /// @param geometry  what is behind the pixels, for its depth; has to outlive this
  LightTarget(const GlFunctions& gl, int width, int height, const GeometryBuffer& geometry);

  /// Binds it; nothing is drawn beside these pixels.
  void begin(const cv::Rect& pixels) const;

  /// Ends what begin() began.
  /// @return CV_16UC4 of the pixels: red, green, blue, 1, numbers of 16 bits
  [[nodiscard]] cv::Mat read(const cv::Rect& pixels) const;

 private:
  const GlFunctions& gl_;
  int width_;
  int height_;
  GlTexture light_;
  GlFramebuffer framebuffer_;
};

}  // namespace synthetic_dataset::render
