#pragma once

#include <optional>
#include <string>

#include "base/sqlite.h"
#include "synthetic_dataset/camera_model.h"

/// Calibrations in the manifest's tables.
namespace synthetic_dataset::output {

/// The column `coefficients`.
[[nodiscard]] std::string coefficientText(const Distortion& distortion);

/// From nine columns, as both tables of cameras have them; nothing for a camera that cannot be.
[[nodiscard]] std::optional<CameraModel> cameraAt(const base::SqliteStatement& row, int first,
                                                  int width, int height);

}  // namespace synthetic_dataset::output
