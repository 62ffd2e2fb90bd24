#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "plugins/readback/drawn_label.h"
#include "plugins/readback/labelled_cloud.h"
#include "synthetic_dataset/camera_model.h"

/// What readers of KITTI's benchmarks share.
namespace synthetic_dataset::formats {

/// The matrix P2 of a calibration file: of the camera that made the images.
[[nodiscard]] Intrinsics readKittiCamera(const std::filesystem::path& file);

/// The scanner's pose in the camera's frame: Tr_velo_to_cam of a calibration file.
[[nodiscard]] Pose readKittiScanner(const std::filesystem::path& file);

/// The objects of a cloud that lines of labels describe; what is DontCare is none.
/// @param lines  of each label, its columns from the type on
/// @param X_CS  as readKittiScanner has it
[[nodiscard]] std::map<std::uint16_t, LabelledCloud::Object> kittiObjects(
    const std::vector<std::vector<std::string>>& lines, const Pose& X_CS,
    const std::filesystem::path& file);

/// The label of a line.
/// @param words  its columns from the type on
/// @throws Error naming the file and a word that is no number
[[nodiscard]] DrawnLabel kittiLabel(const std::vector<std::string>& words, const Intrinsics& camera,
                                    const std::filesystem::path& file);

}  // namespace synthetic_dataset::formats
