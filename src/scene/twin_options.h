#pragma once

#include <cstdint>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::scene {

/// How recorded pictures are labelled; of cameras that have an `image_topic`.
struct TwinOptions {
  std::int64_t every = 1;  ///< every n-th picture of the topic is a scene

  /// So near have the stamps of several cameras' pictures to be that are of one scene.
  Duration same_time = std::chrono::milliseconds(1);
};

}  // namespace synthetic_dataset::scene
