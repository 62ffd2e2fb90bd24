#pragma once

#include "plugins/kitti/kitti_options.h"
#include "plugins/readback/expected_labels.h"

namespace synthetic_dataset::formats {

/// The labels that KITTI's objects, and its tracks, should have in a scene.
[[nodiscard]] ExpectedLabels expectedKittiLabels(const KittiOptions& options,
                                                 const MeasuredScene& scene);

}  // namespace synthetic_dataset::formats
