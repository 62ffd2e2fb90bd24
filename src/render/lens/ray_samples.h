#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/types.hpp>

#include "render/edges/edge_smoother.h"
#include "render/edges/sample_raster.h"
#include "render/lens/lens_sight.h"
#include "render/parts/draw_list.h"

namespace synthetic_dataset::render {

/// The plane of a triangle that is seen, in the lens's frame.
struct SeenPlane {
  int item = 0;
  Eigen::Vector3f normal{0.0F, 0.0F, 0.0F};   ///< of unit length
  Eigen::Vector3f inverse{0.0F, 0.0F, 0.0F};  ///< inverse * p = 1 for its points p
};

/// What the samples of some pixels see through a lens, each along a ray of its own.
class RaySamples {
 public:
  /// @param pixels  that the lens sees something with
  RaySamples(const DrawList& draw_list, const EdgeScene& scene, const LensSight& sight,
             const std::vector<cv::Point>& pixels);

  /// What a sample of pixels[pixel] sees, or null.
  [[nodiscard]] const SeenPlane* at(std::size_t pixel, std::size_t sample) const {
    const int plane = samples_[pixel * kSampleCount + sample];
    return plane < 0 ? nullptr : &planes_[static_cast<std::size_t>(plane)];
  }

 private:
  template <class Grids>
  void take(const Grids& grids, const RaySights& sights, const LensSight& sight);

  std::vector<int> samples_;  ///< of each sample, its plane; -1 for none
  std::vector<SeenPlane> planes_;
};

}  // namespace synthetic_dataset::render
