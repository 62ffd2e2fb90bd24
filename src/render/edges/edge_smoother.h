#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/geometry/geometry_images.h"
#include "render/parts/draw_list.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// What is drawn, from where.
struct EdgeScene {
  View view;
  std::vector<Pose> X_WL;
  LinkSelection drawn;
};

namespace likeness {

// How the pixels around a sample are compared with what it sees, to find the one with its light.
inline constexpr float kAlike = 0.01F;   ///< then its own centre is the nearest there is
inline constexpr float kAway = 0.02F;    ///< what a pixel away counts, against a turn of a radian
inline constexpr float kDepth = 10.0F;   ///< what depth counts: a share of it
inline constexpr float kUnlike = 1e30F;  ///< another surface

}  // namespace likeness

/// What the pixels' centres see.
struct PictureSamples {
  GeometryImages geometry;
  cv::Mat light;   ///< CV_16UC4, red green blue 1 of 16 bits each, linear
  cv::Rect place;  ///< of these pixels in the picture
};

/// Smooths the edges of a picture of which each pixel was lit once, at its centre.
///
/// Pixels by an edge are looked at in several places: what surface is there is found exactly, by
/// drawing triangles for these places alone; the light of it is that of the nearest pixel whose
/// centre sees the same surface (Chajdas, McGuire and Luebke 2011, "Subpixel Reconstruction
/// Antialiasing"). Surfaces with holes, and those that one can see through, keep the edges that
/// pixels' centres give them.
class EdgeSmoother {
 public:
  /// @param draw_list  has to outlive this
  explicit EdgeSmoother(const DrawList& draw_list) : draw_list_(draw_list) {}

  /// @param regions  around the pixels to smooth
  /// @param wanted  CV_8UC1 of the picture: 255 for these; `seen` should hold those around them too
  /// @param picture  CV_8UC3, blue green red, sRGB-encoded, whole
  void smooth(const EdgeScene& scene, const PictureSamples& seen,
              const std::vector<cv::Rect>& regions, const cv::Mat& wanted, cv::Mat& picture) const;

 private:
  const DrawList& draw_list_;
};

}  // namespace synthetic_dataset::render
