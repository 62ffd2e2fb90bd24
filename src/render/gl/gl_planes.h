#pragma once

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

}  // namespace synthetic_dataset::render
