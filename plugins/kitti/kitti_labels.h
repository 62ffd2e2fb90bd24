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

/// What both need of a scene.
[[nodiscard]] Requirements requirementsOf(const KittiOptions& options);

/// A scene's lines; those of tracking without the frame. Warns of objects that are tilted.
[[nodiscard]] std::string labels(const Scene& scene, const KittiOptions& options,
                                 Benchmark benchmark, SceneOutput& output);

/// A file of `calib`.
/// @param X_CS  of the scanner in the camera's optical frame
[[nodiscard]] std::string calibration(const Intrinsics& k, const Pose& X_CS);

/// The pose in the camera's optical frame of a scanner in its place, with x ahead, y left and z up.
[[nodiscard]] Pose scannerInCamera();

/// The same of the lidar whose points there are, and its file of `velodyne`.
[[nodiscard]] Pose lidarInCamera(const Scene& scene, const KittiOptions& options);
[[nodiscard]] std::string lidarPoints(const Scene& scene, const KittiOptions& options);

}  // namespace synthetic_dataset::kitti
