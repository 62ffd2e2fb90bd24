#pragma once

#include <Eigen/Core>

#include "placement/placement_options.h"
#include "random/random_source.h"

namespace synthetic_dataset::placement {

/// A place in a volume, each as likely as the others.
[[nodiscard]] inline Eigen::Vector3d drawWithin(const Volume& volume,
                                                random::RandomSource& source) {
  Eigen::Vector3d place;
  for (int i = 0; i < 3; ++i) place[i] = source.uniform(volume.low[i], volume.high[i]);
  return place;
}

}  // namespace synthetic_dataset::placement
