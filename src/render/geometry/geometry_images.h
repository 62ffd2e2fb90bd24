#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/gl/framebuffer.h"

namespace synthetic_dataset::render {

/// What a geometry buffer holds besides what every world needs.
struct GeometryPlanes {
  bool faces = false;  ///< normals towards the camera, without normal maps; else they are the same
  bool glows = false;  ///< of emissive maps
};

/// A part of a geometry buffer, pixel by pixel, sampled at the pixels' centres.
struct GeometryImages {
  cv::Mat items;    ///< CV_32SC1: the index in the draw list of what is seen + 1, 0 for nothing
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

/// Where surfaces are drawn before they are lit: with depth for OpenGL's test, reversed, and a
/// stencil of 8 bits for SilhouetteBits.
[[nodiscard]] Framebuffer makeGeometryBuffer(const GlFunctions& gl, const cv::Size& size,
                                             const GeometryPlanes& planes);

/// Binds and empties it.
void beginGeometry(const Framebuffer& buffer);

/// Items and depths.
[[nodiscard]] GeometryImages readGeometry(const Framebuffer& buffer, const cv::Rect& pixels);

/// @param place  of the images' pixels in the buffer
/// @param regions  within it; beside them the images hold anything
[[nodiscard]] SurfaceImages readSurfaces(const Framebuffer& buffer, const cv::Rect& place,
                                         const std::vector<cv::Rect>& regions);

}  // namespace synthetic_dataset::render
