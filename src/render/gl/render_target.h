#pragma once

#include <tuple>

#include <opencv2/core/mat.hpp>

#include "render/gl/gl_object.h"

namespace synthetic_dataset::render {

/// What one look at the labels gives, pixel by pixel, sampled at the pixels' centres.
struct LabelImages {
  cv::Mat ids;    ///< CV_32SC1: the identifier that was drawn, 0 where nothing was
  cv::Mat depth;  ///< CV_32FC1: z in the optical frame [m], 0 where nothing was drawn

  // Empty unless asked for.

  /// CV_32SC1: the link's index among the world's links + 1, 0 where nothing was drawn.
  cv::Mat links;

  /// CV_32FC3: the surface's unit normal (x, y, z) in the optical frame, towards the camera; 0
  /// where nothing was drawn. That of the vertices, without normal maps.
  cv::Mat normals;

  /// CV_32FC1: the distance from the camera's centre [m], 0 where nothing was drawn.
  cv::Mat range;
};

/// What a LabelTarget holds besides identifiers and depth.
struct LabelPlanes {
  bool links = false;
  bool normals = false;

  [[nodiscard]] bool operator<(const LabelPlanes& other) const {
    return std::tie(links, normals) < std::tie(other.links, other.normals);
  }
};

/// Where labels are drawn: identifiers, depth and what else is asked for, one sample a pixel.
class LabelTarget {
 public:
  LabelTarget(const GlFunctions& gl, int width, int height, const LabelPlanes& planes);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  /// Binds the target and empties the part of it that is drawn until read().
  /// @param image  the picture's size, at most the target's
  void begin(const cv::Size& image) const;

  /// Without LabelImages::range.
  [[nodiscard]] LabelImages read(const cv::Size& image) const;

 private:
  const GlFunctions& gl_;
  int width_;
  int height_;
  GlTexture ids_;
  GlTexture depth_;
  GlTexture links_;    // none where not asked for
  GlTexture normals_;  // none where not asked for
  GlTexture depth_buffer_;
  GlFramebuffer framebuffer_;
};

/// Where a mask is drawn: one sample a pixel, no depth.
class MaskTarget {
 public:
  MaskTarget(const GlFunctions& gl, int width, int height);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  /// Binds the target and empties a part of it, the only one that is drawn until read().
  /// @param image  the picture's size, at most the target's
  void begin(const cv::Size& image, const cv::Rect& region) const;

  /// CV_8UC1 of the region's size, 255 where something was drawn, 0 elsewhere.
  [[nodiscard]] cv::Mat read(const cv::Rect& region) const;

 private:
  const GlFunctions& gl_;
  int width_;
  int height_;
  GlTexture mask_;
  GlFramebuffer framebuffer_;
};

}  // namespace synthetic_dataset::render
