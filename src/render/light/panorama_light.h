#pragma once

#include <cstddef>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/light/matte_light.h"
#include "render/pixels/lanes.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// The light of a panorama around surfaces, prefiltered once for all of them: for matte surfaces
/// the mean of what they face, and for reflections, by direction and roughness, blurred copies of
/// the panorama.
///
/// Directions are in the panorama's frame: its upper edge is +z, its middle is +x, with -y to the
/// right of it.
class PanoramaLight {
 public:
  /// @param panorama  CV_16UC4: equirectangular; linear red, green, blue and an unused number, as
  ///     half floats (IEEE 754 binary16)
  explicit PanoramaLight(const cv::Mat& panorama);

  /// The light that matte surfaces receive from its upper half, and from its lower half.
  [[nodiscard]] const MatteLight& above() const { return above_; }
  [[nodiscard]] const MatteLight& below() const { return below_; }

  /// What is seen in a mirror, which is the more blurred the rougher the mirror is; 1 where all is
  /// white.
  /// @param directions  the mirror directions, unit vectors
  /// @param roughness  0 .. 1
  [[nodiscard]] Lanes3 mirrored(const Lanes3& directions, const Lanes& roughness) const;

  /// The memory in use [byte].
  [[nodiscard]] std::size_t memory() const;

 private:
  PanoramaLight(const cv::Mat& panorama, const cv::Mat& light);

  MatteLight above_;
  MatteLight below_;

  /// The panoramas seen in ever rougher mirrors: CV_16UC4, made by bordered().
  std::vector<cv::Mat> levels_;
};

/// A picture's light, in the form that PanoramaLight takes; reduced to a width of 2048 pixels if it
/// is wider.
[[nodiscard]] cv::Mat panoramaOf(const world::Texture& picture);

}  // namespace synthetic_dataset::render
