#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/gl/gl_object.h"

namespace synthetic_dataset::render {

/// What a GeometryBuffer holds besides what every world needs.
struct GeometryPlanes {
  bool faces = false;  ///< normals towards the camera, without normal maps; else they are the same
  bool glows = false;  ///< of emissive maps
};

/// A part of a GeometryBuffer, pixel by pixel, sampled at the pixels' centres.
struct GeometryImages {
  cv::Mat items;    ///< CV_32SC1: the place of what is seen in the draw list + 1, 0 for nothing
  cv::Mat depth;    ///< CV_32FC1: z in the optical frame [m], 0 for nothing
  cv::Mat normals;  ///< CV_16UC4: x, y, z in the optical frame, as the vertices have them, without
                    ///< normal maps, as numbers of 16 bits; the fourth means nothing. Empty where
                    ///< they were not read
};

/// What light makes of it, each CV_16UC4, numbers of 16 bits; vectors in the optical frame.
struct SurfaceImages {
  cv::Mat base_roughness;    ///< red, green, blue, linear; roughness
  cv::Mat normal_metalness;  ///< x, y, z as a normal map bends it; metalness
  cv::Mat faces;             ///< x, y, z as the vertices have it, towards the camera; empty where
                             ///< that is the same
  cv::Mat glows;             ///< red, green, blue of an emissive map; empty where there is none

  [[nodiscard]] const cv::Mat& vertexNormals() const {
    return faces.empty() ? normal_metalness : faces;
  }
};

/// Where surfaces are drawn before they are lit, one sample a pixel.
class GeometryBuffer {
 public:
  GeometryBuffer(const GlFunctions& gl, int width, int height, const GeometryPlanes& planes);

  void bind() const;

  /// Binds and empties it.
  void begin() const;

  /// Copies some pixels of all planes to a buffer of the same kind.
  void copyTo(const GeometryBuffer& to, const cv::Rect& pixels) const;

  /// Depth for OpenGL's depth test, reversed; and a stencil of 8 bits, which is empty at first.
  [[nodiscard]] const GlTexture& depthBuffer() const { return depth_buffer_; }

  /// Items and depths.
  [[nodiscard]] GeometryImages read(const cv::Rect& pixels) const;

  /// @param place  of the images' pixels in the buffer
  /// @param regions  within it; beside them the images hold anything
  [[nodiscard]] SurfaceImages readSurfaces(const cv::Rect& place,
                                           const std::vector<cv::Rect>& regions) const;

  /// CV_8UC1: the bits that were set (SilhouetteBits).
  [[nodiscard]] cv::Mat readStencil(const cv::Rect& pixels) const;

 private:
  const GlFunctions& gl_;
  int width_;
  int height_;
  GlTexture parts_depths_;
  GlTexture base_roughness_;
  GlTexture normal_metalness_;
  GlTexture faces_;  // none where not asked for
  GlTexture glows_;  // none where not asked for
  GlTexture depth_buffer_;
  GlFramebuffer framebuffer_;
};

}  // namespace synthetic_dataset::render
