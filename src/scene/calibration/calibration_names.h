#pragma once

#include <map>
#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::scene {

/// A name in the form used for comparison, in lower case and without underscores: "Camera_Matrix"
/// is "cameramatrix".
[[nodiscard]] std::string plainName(const std::string& name);

/// Renames a map's entries to the names in camera_calibration's files (image_width, camera_matrix,
/// ...); other entries keep theirs. Matrices become the list of their entries, row by row.
/// @param names  from plain names to those of camera_calibration
[[nodiscard]] Value::Map withUsualNames(const Value::Map& map,
                                        const std::map<std::string, std::string>& names);

/// ROS's names, for withUsualNames().
[[nodiscard]] const std::map<std::string, std::string>& rosNames();

/// A number of pixels, as an integer if it is whole.
[[nodiscard]] Value pixelCount(double number);

/// A matrix as a flat list: from a group with `data`, a list, or a list of rows.
[[nodiscard]] Value flatMatrix(const Value& matrix);

}  // namespace synthetic_dataset::scene
