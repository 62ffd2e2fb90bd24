#pragma once

#include <map>
#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::scene {

/// A name as it is compared, without capitals and underscores: "Camera_Matrix" is "cameramatrix".
[[nodiscard]] std::string plainName(const std::string& name);

/// Gives a map's entries the names of camera_calibration's files (image_width, camera_matrix, ...);
/// others keep theirs. Of matrices, the list of their entries is left, row by row.
/// @param names  plain names to those of camera_calibration
[[nodiscard]] Value::Map withUsualNames(const Value::Map& map,
                                        const std::map<std::string, std::string>& names);

/// ROS's names, for withUsualNames().
[[nodiscard]] const std::map<std::string, std::string>& rosNames();

/// A number of pixels, as a whole number if it is one.
[[nodiscard]] Value pixelCount(double number);

/// A matrix as a list: of a group with `data`, a list, or a list of rows.
[[nodiscard]] Value flatMatrix(const Value& matrix);

}  // namespace synthetic_dataset::scene
