#pragma once

#include <vector>

#include "config/config.h"
#include "run/setup/motion_setup.h"
#include "run/setup/split_plan.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::run {

/// Builds the description that writers receive before the first scene.
/// @param config  the settings that apply to the whole dataset
/// @param motions  at least one; the description refers to the links of their worlds
[[nodiscard]] DatasetInfo describeDataset(const config::Config& config,
                                          const std::vector<MotionSetup>& motions,
                                          const SplitPlan& splits);

}  // namespace synthetic_dataset::run
