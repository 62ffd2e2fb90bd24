#pragma once

#include <optional>
#include <string>

#include "base/sqlite.h"
#include "synthetic_dataset/camera_model.h"

/// Reads and writes calibrations in the manifest's tables.
namespace synthetic_dataset::output {

/// The column `coefficients`.
[[nodiscard]] std::string coefficientText(const Distortion& distortion);

/// Reads nine columns, laid out as in both camera tables; nothing if the camera is not valid.
[[nodiscard]] std::optional<CameraModel> cameraAt(const base::SqliteStatement& row, int first,
                                                  int width, int height);

}  // namespace synthetic_dataset::output
