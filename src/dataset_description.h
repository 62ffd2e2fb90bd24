#pragma once

#include <cstdint>
#include <vector>

#include "camera_rig.h"
#include "config/config.h"
#include "split_plan.h"
#include "synthetic_dataset/label_writer.h"
#include "world/world.h"

namespace synthetic_dataset {

/// What writers are told before the first scene.
/// @param links  of the world; the description holds on to the links that they point to
[[nodiscard]] DatasetInfo describeDataset(const config::Config& config,
                                          const std::vector<CameraRig>& cameras,
                                          const std::vector<world::LinkInstance>& links,
                                          std::int64_t instant_count, const SplitPlan& splits);

}  // namespace synthetic_dataset
