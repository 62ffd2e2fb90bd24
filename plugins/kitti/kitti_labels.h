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
/// @param X_CS  of the scanner in the camera's optical frame
[[nodiscard]] std::string calibration(const Intrinsics& k, const Pose& X_CS);

/// That of a scanner in the camera's place, with x ahead, y left and z up.
[[nodiscard]] Pose scannerInCamera();

}  // namespace synthetic_dataset::kitti
