#pragma once

#include <opencv2/core/mat.hpp>

#include "render/gl_object.h"

namespace synthetic_dataset::render {

/// Where the colour image is drawn: several samples a pixel, averaged when it is read.
class ColourTarget {
 public:
  /// @param samples  a pixel; 1 for none but the centre's
  ColourTarget(const GlFunctions& gl, int width, int height, int samples);

  /// Binds the target and fills it with a colour (linear red, green, blue).
  void begin(const float background[3]) const;

  /// The picture: CV_8UC3, blue green red, sRGB-encoded, first row on top.
  [[nodiscard]] cv::Mat read() const;

 private:
  const GlFunctions& gl_;
  int width_;
  int height_;
  GlTexture samples_colour_;
  GlTexture samples_depth_;
  GlTexture resolved_colour_;
  GlFramebuffer samples_;
  GlFramebuffer resolved_;
};

/// What one look at the labels gives, pixel by pixel, sampled at the pixels' centres.
struct LabelImages {
  cv::Mat ids;    ///< CV_32SC1: the identifier that was drawn, 0 where nothing was
  cv::Mat depth;  ///< CV_32FC1: z in the optical frame [m], 0 where nothing was drawn
};

/// Where labels are drawn: identifiers and depth, one sample a pixel.
class LabelTarget {
 public:
  LabelTarget(const GlFunctions& gl, int width, int height);

  void begin() const;
  [[nodiscard]] LabelImages read() const;

 private:
  const GlFunctions& gl_;
  int width_;
  int height_;
  GlTexture ids_;
  GlTexture depth_;
  GlTexture depth_buffer_;
  GlFramebuffer framebuffer_;
};

}  // namespace synthetic_dataset::render
