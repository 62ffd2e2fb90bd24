#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <Eigen/Core>

#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/cuboid.h"
#include "synthetic_dataset/label_writer.h"
#include "synthetic_dataset/object_model.h"

/// What the formats that hold poses or cameras (KITTI, BOP, PVNet, DOPE, Cityscapes) share.
namespace synthetic_dataset {

/// A number as such formats name files: six digits with leading zeros, "000012".
[[nodiscard]] std::string sixDigits(std::int64_t number);

/// Warns where a scene's lens is not the pinhole that the format takes it for.
void warnOfDistortion(const CameraModel& camera, SceneOutput& output);

/// The 3x3 camera matrix, row by row.
[[nodiscard]] std::array<double, 9> cameraMatrix(const Intrinsics& intrinsics);

/// A pose's rotation matrix, row by row.
[[nodiscard]] std::array<double, 9> rotationMatrix(const Pose& pose);

/// The smallest box around a model that has vertices.
[[nodiscard]] Cuboid boundsOf(const ObjectModel& model);

}  // namespace synthetic_dataset
