#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "plugins/readback/drawn_label.h"
#include "plugins/readback/labelled_cloud.h"
#include "plugins/readback/written_scene.h"
#include "synthetic_dataset/camera_model.h"

/// What readers of KITTI's benchmarks share.
namespace synthetic_dataset::formats {

/// The matrix P2 of a calibration file: of the camera that made the images.
[[nodiscard]] Intrinsics readKittiCamera(const std::filesystem::path& file);

/// The lidar whose points a writer's `velodyne` asks for; nothing for those of a depth image.
[[nodiscard]] std::optional<std::string> kittiLidar(const WrittenScene& scene);

/// The lidar's points, and the objects that lines of labels describe; what is DontCare is none.
/// @param lines  of each label, its columns from the type on
/// @param file, calibration  where the labels stand, and what says where the scanner is
[[nodiscard]] LabelledCloud kittiCloud(const WrittenScene& scene,
                                       const std::vector<std::vector<std::string>>& lines,
                                       const std::filesystem::path& file,
                                       const std::filesystem::path& calibration);

/// The label of a line.
/// @param words  its columns from the type on
/// @throws Error naming the file and a word that is no number
[[nodiscard]] DrawnLabel kittiLabel(const std::vector<std::string>& words, const Intrinsics& camera,
                                    const std::filesystem::path& file);

}  // namespace synthetic_dataset::formats
