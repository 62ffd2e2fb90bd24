#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "plugins/readback/format.h"
#include "synthetic_dataset/label_writer.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::formats {

/// The index of a lidar; nothing if there is none of this name.
[[nodiscard]] std::optional<std::size_t> lidarNamed(const std::string& name,
                                                    const DatasetInfo& dataset);

/// The points of a file in KITTI's form, in the form that the manifest has a digest of.
/// @param settings  of the writer, with `motion_corrected`
/// @throws Error if it ends within a point
[[nodiscard]] DecodedPicture velodynePicture(const std::filesystem::path& file, std::size_t lidar,
                                             const Value::Map& settings);

}  // namespace synthetic_dataset::formats
