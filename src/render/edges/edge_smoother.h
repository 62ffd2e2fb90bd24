#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/geometry/geometry_images.h"
#include "render/parts/draw_list.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// What is drawn, and from where.
struct EdgeScene {
  View view;
  std::vector<Pose> X_WL;
  LinkSelection drawn;
};

namespace likeness {

// How the pixels around a sample are compared with what it sees, to find the pixel from which to
// take its light. The least unlike one is chosen.
inline constexpr float kAlike = 0.01F;   ///< below this, the sample's own pixel is taken
inline constexpr float kAway = 0.02F;    ///< weight of the squared distance [px]
inline constexpr float kDepth = 10.0F;   ///< weight of the relative difference in depth
inline constexpr float kUnlike = 1e30F;  ///< for a different surface

}  // namespace likeness

/// What the pixels' centres see.
struct PictureSamples {
  GeometryImages geometry;
  cv::Mat light;   ///< CV_16UC4, half floats: linear red, green, blue, and 1
  cv::Rect place;  ///< of these pixels in the picture
};

/// Smooths the edges of a picture in which each pixel was lit once, at its centre.
///
/// Pixels at an edge are sampled in several places: the surface there is found exactly, by drawing
/// triangles at these places only; its light is that of the nearest pixel whose centre sees the
/// same surface (Chajdas, McGuire and Luebke 2011, "Subpixel Reconstruction Antialiasing").
/// Surfaces with holes, and see-through ones, keep the edges that the pixels' centres give them.
class EdgeSmoother {
 public:
  /// @param draw_list  has to outlive this object
  explicit EdgeSmoother(const DrawList& draw_list) : draw_list_(draw_list) {}

  /// @param regions  contain all pixels to smooth
  /// @param wanted  CV_8UC1, of the picture: 255 for the pixels to smooth; `seen` should include
  ///   the pixels around them too
  /// @param picture  CV_8UC3, blue green red, sRGB-encoded, whole
  void smooth(const EdgeScene& scene, const PictureSamples& seen,
              const std::vector<cv::Rect>& regions, const cv::Mat& wanted, cv::Mat& picture) const;

 private:
  const DrawList& draw_list_;
};

}  // namespace synthetic_dataset::render
