#pragma once

#include <string>

#include "plugins/kitti/kitti_options.h"
#include "synthetic_dataset/label_writer.h"

/// What KITTI's benchmarks of objects and of tracking share.
namespace synthetic_dataset::kitti {

/// How far behind a surface its points of a scan lie [m].
inline constexpr double kScanDepth = 0.001;

/// Their lines differ in a few columns.
enum class Benchmark { kObjects, kTracking };

/// A scene's lines; those of tracking without the frame. Warns of objects that are tilted.
[[nodiscard]] std::string labels(const Scene& scene, const KittiOptions& options,
                                 Benchmark benchmark, SceneOutput& output);

/// A file of `calib`.
[[nodiscard]] std::string calibration(const Intrinsics& k);

}  // namespace synthetic_dataset::kitti
