#pragma once

#include <cstdint>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::scene {

/// Which pictures the scenes have.
enum class TwinOutput {
  kReal,       ///< the recorded ones
  kSynthetic,  ///< those that are drawn of the same instants
};

/// How recorded pictures are labelled; of cameras that have an `image_topic`.
struct TwinOptions {
  TwinOutput output = TwinOutput::kReal;
  std::int64_t every = 1;  ///< every n-th picture of the topic is a scene

  double min_alignment = 0.0;  ///< scenes below it are left out (label::Alignment), 0 .. 1

  /// So near have the stamps of several cameras' pictures to be that are of one scene.
  Duration same_time = std::chrono::milliseconds(1);
};

}  // namespace synthetic_dataset::scene
