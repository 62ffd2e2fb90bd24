#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/gl/gl_object.h"

namespace synthetic_dataset::render {

/// A picture of one level without contents.
/// @param format  sized: GL_R32F
[[nodiscard]] GlTexture makePlane(const GlFunctions& gl, GLenum format, int width, int height);

/// Makes the planes the outputs 0, 1, ... of what is drawn into a framebuffer; outputs whose plane
/// is none are not kept.
/// @param depth  for the depth test, or none
/// @param depth_attachment  GL_DEPTH_STENCIL_ATTACHMENT where it has a stencil that is used
/// @throws Error when OpenGL cannot draw into them
void attachPlanes(const GlFunctions& gl, const GlFramebuffer& framebuffer,
                  const std::vector<const GlTexture*>& planes, const GlTexture* depth,
                  GLenum depth_attachment = GL_DEPTH_ATTACHMENT);

/// Some pixels of an output of the framebuffer, which has to be bound.
/// @param type  of the matrix, that of `format` and `component`
[[nodiscard]] cv::Mat readPlane(const GlFunctions& gl, const GlFramebuffer& framebuffer, int output,
                                const cv::Rect& pixels, int type, GLenum format, GLenum component);

/// Those of several regions in an image of `place`, which holds anything beside them.
[[nodiscard]] cv::Mat readPlane(const GlFunctions& gl, const GlFramebuffer& framebuffer, int output,
                                const cv::Rect& place, const std::vector<cv::Rect>& regions,
                                int type, GLenum format, GLenum component);

/// What shaders draw into, one sample a pixel: an image for each of their outputs, and depth.
class Framebuffer {
 public:
  /// @param formats  of the outputs 0, 1, ..., sized (GL_R32F); GL_NONE where one is not kept
  /// @param depth  its format, GL_DEPTH32F_STENCIL8 for one with a stencil; GL_NONE for no depth
  /// @throws Error when OpenGL cannot draw into them
  Framebuffer(const GlFunctions& gl, const cv::Size& size, std::vector<GLenum> formats,
              GLenum depth = GL_NONE);

  /// One of the same size with the same depth.
  /// @param with_depth  has to outlive this
  Framebuffer(const Framebuffer& with_depth, std::vector<GLenum> formats);

  [[nodiscard]] const cv::Size& size() const { return size_; }

  /// Draws into all of it from now on.
  void bind() const;

  /// Draws an image into it from now on, but only some of its pixels until read().
  /// @param image  its size, at most size()
  void bind(const cv::Size& image, const cv::Rect& pixels) const;

  // Fill the bound pixels of an output, if it is kept.

  void clear(std::size_t output, const std::array<float, 4>& value) const;
  void clearToZero(std::size_t output) const;

  /// Empties the bound pixels of depth, which is reversed, and of the stencil.
  void clearDepth() const;

  /// Some pixels of an output, in the type of cv::Mat that its format has; empty where the output
  /// is not kept.
  [[nodiscard]] cv::Mat read(std::size_t output, const cv::Rect& pixels) const;

  /// Those of several regions in an image of `place`, which holds anything beside them.
  [[nodiscard]] cv::Mat read(std::size_t output, const cv::Rect& place,
                             const std::vector<cv::Rect>& regions) const;

  /// CV_8UC1.
  [[nodiscard]] cv::Mat readStencil(const cv::Rect& pixels) const;

  /// Copies some pixels of all that it holds to another one of the same formats.
  void copyTo(const Framebuffer& to, const cv::Rect& pixels) const;

 private:
  void attach(const GlTexture& depth) const;
  [[nodiscard]] bool hasStencil() const { return depth_format_ == GL_DEPTH32F_STENCIL8; }

  const GlFunctions& gl_;
  cv::Size size_;
  std::vector<GLenum> formats_;
  std::vector<GlTexture> outputs_;
  GLenum depth_format_;
  GlTexture depth_;  ///< none where it is another one's
  GlFramebuffer framebuffer_;
};

/// A framebuffer that an image fits into: the one that there is, or a new one where it is too
/// small, as pictures are of many sizes.
[[nodiscard]] const Framebuffer& holding(const GlFunctions& gl, const cv::Size& image,
                                         const std::vector<GLenum>& formats, GLenum depth,
                                         std::optional<Framebuffer>& framebuffer);

}  // namespace synthetic_dataset::render
