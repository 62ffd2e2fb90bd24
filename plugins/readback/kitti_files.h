#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "plugins/readback/drawn_label.h"
#include "synthetic_dataset/camera_model.h"

/// What readers of KITTI's benchmarks share.
namespace synthetic_dataset::formats {

/// The matrix P2 of a calibration file: of the camera that made the images.
[[nodiscard]] Intrinsics readKittiCamera(const std::filesystem::path& file);

/// The label of a line.
/// @param words  its columns from the type on
/// @throws Error naming the file and a word that is no number
[[nodiscard]] DrawnLabel kittiLabel(const std::vector<std::string>& words, const Intrinsics& camera,
                                    const std::filesystem::path& file);

}  // namespace synthetic_dataset::formats
