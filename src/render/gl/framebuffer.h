#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/gl/gl_object.h"

namespace synthetic_dataset::render {

/// A texture of one level, with undefined contents.
/// @param format  a sized one, for example GL_R32F
[[nodiscard]] GlTexture makePlane(const GlFunctions& gl, GLenum format, int width, int height);

/// Attaches the planes to a framebuffer as its outputs 0, 1, ...; outputs whose plane is an empty
/// GlTexture are not kept.
/// @param depth  for the depth test, or null
/// @param depth_attachment  GL_DEPTH_STENCIL_ATTACHMENT if `depth` has a stencil that is used
/// @throws Error when OpenGL cannot draw into the planes
void attachPlanes(const GlFunctions& gl, const GlFramebuffer& framebuffer,
                  const std::vector<const GlTexture*>& planes, const GlTexture* depth,
                  GLenum depth_attachment = GL_DEPTH_ATTACHMENT);

/// Reads some pixels of an output of the framebuffer, which has to be bound.
/// @param type  of the matrix; has to match `format` and `component`
[[nodiscard]] cv::Mat readPlane(const GlFunctions& gl, const GlFramebuffer& framebuffer, int output,
                                const cv::Rect& pixels, int type, GLenum format, GLenum component);

/// Reads the pixels of several regions into an image of `place`, which is undefined outside them.
[[nodiscard]] cv::Mat readPlane(const GlFunctions& gl, const GlFramebuffer& framebuffer, int output,
                                const cv::Rect& place, const std::vector<cv::Rect>& regions,
                                int type, GLenum format, GLenum component);

/// What shaders draw into, one sample per pixel: an image for each of their outputs, and depth.
class Framebuffer {
 public:
  /// @param formats  sized formats (such as GL_R32F) of the outputs 0, 1, ...; GL_NONE for an
  ///   output that is not kept
  /// @param depth  its format, GL_DEPTH32F_STENCIL8 for one with a stencil; GL_NONE for no depth
  /// @throws Error when OpenGL cannot draw into these formats
  Framebuffer(const GlFunctions& gl, const cv::Size& size, std::vector<GLenum> formats,
              GLenum depth = GL_NONE);

  /// Makes a framebuffer that shares another one's depth, and has its size.
  /// @param with_depth  has to outlive the new framebuffer
  Framebuffer(const Framebuffer& with_depth, std::vector<GLenum> formats);

  [[nodiscard]] const cv::Size& size() const { return size_; }

  /// Makes drawing go to all of this framebuffer from now on.
  void bind() const;

  /// Makes drawing go to this framebuffer from now on, as an image of which only some pixels are
  /// drawn, until read().
  /// @param image  the size of the image, at most size()
  void bind(const cv::Size& image, const cv::Rect& pixels) const;

  // Fills the bound pixels of an output, if that is kept.

  void clear(std::size_t output, const std::array<float, 4>& value) const;
  void clearToZero(std::size_t output) const;

  /// Clears the bound pixels of the depth (to 0, the farthest, as it is reversed) and of the
  /// stencil.
  void clearDepth() const;

  /// Reads some pixels of an output, as a cv::Mat of the type that corresponds to the output's
  /// format; empty if the output is not kept.
  [[nodiscard]] cv::Mat read(std::size_t output, const cv::Rect& pixels) const;

  /// Reads the pixels of several regions into an image of `place`, which is undefined outside them.
  [[nodiscard]] cv::Mat read(std::size_t output, const cv::Rect& place,
                             const std::vector<cv::Rect>& regions) const;

  /// CV_8UC1.
  [[nodiscard]] cv::Mat readStencil(const cv::Rect& pixels) const;

  /// Copies some pixels of all outputs and of the depth to another framebuffer of the same formats.
  void copyTo(const Framebuffer& to, const cv::Rect& pixels) const;

 private:
  void attach(const GlTexture& depth) const;
  [[nodiscard]] bool hasStencil() const { return depth_format_ == GL_DEPTH32F_STENCIL8; }

  const GlFunctions& gl_;
  cv::Size size_;
  std::vector<GLenum> formats_;
  std::vector<GlTexture> outputs_;
  GLenum depth_format_;
  GlTexture depth_;  ///< empty if another framebuffer's depth is used
  GlFramebuffer framebuffer_;
};

/// A framebuffer that an image fits into: the given one, which is replaced by a larger one if it is
/// missing or too small, as pictures have many sizes.
[[nodiscard]] const Framebuffer& framebufferFor(const GlFunctions& gl, const cv::Size& image,
                                                const std::vector<GLenum>& formats, GLenum depth,
                                                std::optional<Framebuffer>& framebuffer);

}  // namespace synthetic_dataset::render
