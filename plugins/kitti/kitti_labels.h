#pragma once

#include <string>

#include "plugins/kitti/kitti_options.h"
#include "synthetic_dataset/label_writer.h"

/// Shared by KITTI's object and tracking benchmarks.
namespace synthetic_dataset::kitti {

/// How far behind a surface its scanned points lie [m].
inline constexpr double kScanDepth = 0.001;

/// The benchmarks' label lines differ in a few columns.
enum class Benchmark { kObjects, kTracking };

/// What both benchmarks need from a scene.
[[nodiscard]] Requirements requirementsOf(const KittiOptions& options);

/// A scene's label lines; those of tracking without the frame number. Warns of objects that are
/// tilted.
[[nodiscard]] std::string labels(const Scene& scene, const KittiOptions& options,
                                 Benchmark benchmark, SceneOutput& output);

/// The content of a file in `calib`.
/// @param X_CS  of the scanner in the camera's optical frame
[[nodiscard]] std::string calibration(const Intrinsics& k, const Pose& X_CS);

/// The pose in the camera's optical frame of a scanner at the camera's position, with x ahead, y
/// left and z up.
[[nodiscard]] Pose scannerInCamera();

/// The pose in the camera's optical frame of the lidar that provides the points, and its `velodyne`
/// file.
[[nodiscard]] Pose lidarInCamera(const Scene& scene, const KittiOptions& options);
[[nodiscard]] std::string lidarPoints(const Scene& scene, const KittiOptions& options);

}  // namespace synthetic_dataset::kitti
