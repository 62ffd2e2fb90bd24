#pragma once

#include "motion/motion_options.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {

/// Reads `tf_topics` and `pose_topics`: what of a recording is read.
void readTopics(Parameters& root, motion::MotionOptions& motion);

}  // namespace synthetic_dataset::config
