#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "plugins/readback/drawn_label.h"
#include "plugins/readback/labelled_cloud.h"
#include "plugins/readback/written_scene.h"
#include "synthetic_dataset/camera_model.h"

/// Shared by the readers of KITTI's benchmarks.
namespace synthetic_dataset::formats {

/// The matrix P2 of a calibration file: that of the camera that took the images.
[[nodiscard]] Intrinsics readKittiCamera(const std::filesystem::path& file);

/// The lidar whose points a writer's `velodyne` asks for; nothing if they come from a depth image.
[[nodiscard]] std::optional<std::string> kittiLidar(const WrittenScene& scene);

/// The lidar's points, and the objects described by label lines, without DontCare regions.
/// @param lines  for each label, its columns from the type on
/// @param file, calibration  the files of the labels, and of the scanner's pose
[[nodiscard]] LabelledCloud kittiCloud(const WrittenScene& scene,
                                       const std::vector<std::vector<std::string>>& lines,
                                       const std::filesystem::path& file,
                                       const std::filesystem::path& calibration);

/// The label described by a line.
/// @param words  its columns from the type on
/// @throws Error naming the file and a word that is not a number
[[nodiscard]] DrawnLabel kittiLabel(const std::vector<std::string>& words, const Intrinsics& camera,
                                    const std::filesystem::path& file);

}  // namespace synthetic_dataset::formats
