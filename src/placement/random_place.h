#pragma once

#include <Eigen/Core>

#include "config/placement_config.h"
#include "random/random_source.h"

namespace synthetic_dataset::placement {

/// A place in a volume, each as likely as the others.
[[nodiscard]] inline Eigen::Vector3d drawWithin(const config::Volume& volume,
                                                random::RandomSource& source) {
  Eigen::Vector3d place;
  for (int i = 0; i < 3; ++i) place[i] = source.uniform(volume.low[i], volume.high[i]);
  return place;
}

}  // namespace synthetic_dataset::placement
