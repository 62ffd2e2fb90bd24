#pragma once

#include <Eigen/Core>

#include "base/random/random_source.h"
#include "randomize/placement/placement_options.h"

namespace synthetic_dataset::randomize {

/// A place in a volume, drawn uniformly.
[[nodiscard]] inline Eigen::Vector3d drawWithin(const Volume& volume, base::RandomSource& source) {
  Eigen::Vector3d place;
  for (int i = 0; i < 3; ++i) place[i] = source.uniform(volume.low[i], volume.high[i]);
  return place;
}

}  // namespace synthetic_dataset::randomize
