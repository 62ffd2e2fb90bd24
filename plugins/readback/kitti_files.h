#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/camera_model.h"

/// What readers of KITTI's benchmarks share.
namespace synthetic_dataset::formats {

/// The matrix P2 of a calibration file: of the camera that made the images.
[[nodiscard]] Intrinsics readKittiCamera(const std::filesystem::path& file);

/// The corners of a label's 3D box in the camera's frame [m], in the order of Cuboid::corners().
/// @param columns  the seven from height on
[[nodiscard]] std::array<Eigen::Vector3d, 8> kittiCorners(const std::vector<double>& columns);

}  // namespace synthetic_dataset::formats
