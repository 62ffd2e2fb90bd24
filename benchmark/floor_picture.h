#pragma once

#include <opencv2/core.hpp>

#include "render/gl/gl_object.h"

namespace synthetic_dataset::benchmark {

/// The targets that the floor draws into: colour and identifiers, one or more samples per pixel.
class FloorPicture {
 public:
  FloorPicture(const render::GlFunctions& gl, const cv::Size& size, GLsizei samples);

  /// Clears the picture and binds it as the target.
  void begin() const;

  /// Writes each pixel's mean colour and first identifier to a picture that is to be read.
  void resolveTo(const FloorPicture& one) const;

  [[nodiscard]] cv::Mat readColour() const;       ///< CV_8UC3: blue, green, red
  [[nodiscard]] cv::Mat readIdentifiers() const;  ///< CV_32SC1

 private:
  [[nodiscard]] render::GlTexture plane(GLenum format) const;
  void bind() const;

  const render::GlFunctions& gl_;
  cv::Size size_;
  GLsizei samples_;
  render::GlTexture colour_, identifiers_, depth_;
  render::GlFramebuffer framebuffer_;
};

}  // namespace synthetic_dataset::benchmark
