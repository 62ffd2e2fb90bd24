#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "render/pixels/lanes.h"
#include "render/pixels/light_picture.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// A texture that is filtered as by OpenGL (GL_LINEAR_MIPMAP_LINEAR, GL_REPEAT), for lookups
/// without OpenGL.
class PicturePyramid {
 public:
  PicturePyramid(const world::Texture& texture, PixelMeaning meaning);

  /// The mean red, green, blue and alpha over the parallelogram that two steps span around a place.
  /// Colours are linear.
  /// @param across, along  a pixel's step on the picture to the right and down, in units of the
  ///     picture's width and height
  [[nodiscard]] Eigen::Vector4f mean(const Eigen::Vector2f& place, const Eigen::Vector2f& across,
                                     const Eigen::Vector2f& along) const;

  /// The colour as OpenGL filters it: equally in all directions, by the longer step.
  [[nodiscard]] Eigen::Vector4f sample(const Eigen::Vector2f& place, const Eigen::Vector2f& across,
                                       const Eigen::Vector2f& along) const;

 private:
  /// Four places on a picture, in units of its width and height.
  struct FourPlaces {
    Lanes x, y;
  };

  [[nodiscard]] Eigen::Vector2f inTexels(const Eigen::Vector2f& step) const;
  [[nodiscard]] Lanes sumAt(FourPlaces places, int count, float level, Lanes sum) const;

  std::vector<cv::Mat> levels_;  ///< CV_16UC4 as returned by toLight(), the largest first
};

/// Makes each texture's pyramid once for each meaning, when first requested.
class PyramidLibrary {
 public:
  [[nodiscard]] std::shared_ptr<const PicturePyramid> get(
      const std::shared_ptr<const world::Texture>& texture, PixelMeaning meaning);

  /// Releases pictures that nothing else uses any more.
  void forgetUnused();

 private:
  std::map<std::pair<std::shared_ptr<const world::Texture>, PixelMeaning>,
           std::shared_ptr<const PicturePyramid>>
      pyramids_;
};

}  // namespace synthetic_dataset::render
