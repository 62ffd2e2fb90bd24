#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/gl/framebuffer.h"

namespace synthetic_dataset::render {

/// What a geometry buffer contains besides what every world needs.
struct GeometryPlanes {
  bool faces = false;  ///< normals towards the camera, without normal maps, if these differ
  bool glows = false;  ///< colours of emissive maps
};

/// A part of a geometry buffer, sampled at the pixels' centres.
struct GeometryImages {
  cv::Mat items;    ///< CV_32SC1: the visible item's index in the draw list + 1, 0 for nothing
  cv::Mat depth;    ///< CV_32FC1: z in the optical frame [m], 0 for nothing
  cv::Mat normals;  ///< CV_16UC4, half floats: x, y, z in the optical frame, interpolated from the
                    ///< vertices, without normal maps; the fourth is unused. Empty if they were
                    ///< not read
};

/// The properties of surfaces that lighting needs, each CV_16UC4, half floats; vectors are in the
/// optical frame.
struct SurfaceImages {
  cv::Mat base_roughness;    ///< red, green, blue, linear; roughness
  cv::Mat normal_metalness;  ///< x, y, z of the normal as bent by a normal map; metalness
  cv::Mat faces;             ///< x, y, z of the vertices' normal, towards the camera; empty if
                             ///< it is the same as the bent one
  cv::Mat glows;             ///< red, green, blue of an emissive map; empty if there is none

  [[nodiscard]] const cv::Mat& vertexNormals() const {
    return faces.empty() ? normal_metalness : faces;
  }
};

/// Makes the buffer into which surfaces are drawn before they are lit: with reversed depth for
/// OpenGL's depth test, and an 8-bit stencil for SilhouetteBits.
[[nodiscard]] Framebuffer makeGeometryBuffer(const GlFunctions& gl, const cv::Size& size,
                                             const GeometryPlanes& planes);

/// Binds and clears a geometry buffer.
void beginGeometry(const Framebuffer& buffer);

/// Reads items and depths.
[[nodiscard]] GeometryImages readGeometry(const Framebuffer& buffer, const cv::Rect& pixels);

/// @param place  of the images' pixels in the buffer
/// @param regions  within `place`; outside them the images are undefined
[[nodiscard]] SurfaceImages readSurfaces(const Framebuffer& buffer, const cv::Rect& place,
                                         const std::vector<cv::Rect>& regions);

}  // namespace synthetic_dataset::render
