#pragma once

#include <opencv2/core.hpp>

#include "render/gl/gl_object.h"

namespace synthetic_dataset::benchmark {

/// What the floor draws into: colour and identifiers, of one sample a pixel or of several.
class FloorPicture {
 public:
  FloorPicture(const render::GlFunctions& gl, const cv::Size& size, GLsizei samples);

  /// Empties it and makes it what is drawn into.
  void begin() const;

  /// Colours become the means of their samples, identifiers those of the first; that is to be read.
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
