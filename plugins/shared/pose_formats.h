#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <Eigen/Core>

#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/cuboid.h"
#include "synthetic_dataset/label_writer.h"
#include "synthetic_dataset/object_model.h"

/// Shared by the formats that contain poses or cameras (KITTI, BOP, PVNet, DOPE, Cityscapes).
namespace synthetic_dataset {

/// A number as in these formats' file names: six digits with leading zeros, "000012".
[[nodiscard]] std::string sixDigits(std::int64_t number);

/// Warns if a scene's lens is not the pinhole that the format assumes.
void warnOfDistortion(const CameraModel& camera, SceneOutput& output);

/// The 3x3 camera matrix, row by row.
[[nodiscard]] std::array<double, 9> cameraMatrix(const Intrinsics& intrinsics);

/// A pose's rotation matrix, row by row.
[[nodiscard]] std::array<double, 9> rotationMatrix(const Pose& pose);

/// The smallest box around a model, which must have vertices.
[[nodiscard]] Cuboid boundsOf(const ObjectModel& model);

}  // namespace synthetic_dataset
