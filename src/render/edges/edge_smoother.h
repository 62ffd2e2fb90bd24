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
