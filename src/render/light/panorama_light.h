#pragma once

#include <cstddef>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/light/matte_light.h"
#include "render/pixels/lanes.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// What surfaces make of the light of a panorama that lies around them, found once for all of them:
/// of matte ones the mean of what they face, and what others mirror by its direction and their
/// roughness, for which there are blurred copies of the panorama.
///
/// Directions are the panorama's: its upper edge is +z, its middle +x, to the right of which is -y.
class PanoramaLight {
 public:
  /// @param panorama  CV_16UC4: equirectangular; red, green, blue and any, linear numbers of 16
  ///     bits (IEEE 754 binary16)
  explicit PanoramaLight(const cv::Mat& panorama);

  /// What arrives at matte surfaces from its upper half, and from its lower half.
  [[nodiscard]] const MatteLight& above() const { return above_; }
  [[nodiscard]] const MatteLight& below() const { return below_; }

  /// What is seen in a mirror, more blurred the rougher it is; 1 where all is white.
  /// @param directions  to where the mirror shows, unit vectors
  /// @param roughness  0 .. 1
  [[nodiscard]] Lanes3 mirrored(const Lanes3& directions, const Lanes& roughness) const;

  /// [byte]
  [[nodiscard]] std::size_t memory() const;

 private:
  PanoramaLight(const cv::Mat& panorama, const cv::Mat& light);

  MatteLight above_;
  MatteLight below_;

  /// Ever rougher mirrors' panoramas: CV_16UC4, with one pixel more at each edge, which is what
  /// lies beyond it.
  std::vector<cv::Mat> levels_;
};

/// A picture's light, as PanoramaLight takes it; of one that is wider than 2048 pixels, reduced to
/// that.
[[nodiscard]] cv::Mat panoramaOf(const world::Texture& picture);

}  // namespace synthetic_dataset::render
