#pragma once

#include <string>

#include "plugins/readback/found_files.h"
#include "synthetic_dataset/cuboid.h"
#include "synthetic_dataset/object_model.h"

namespace synthetic_dataset::formats {

/// Compares a PLY file with the surface that it should hold.
/// @param scale  what a metre is in the file
void comparePly(const std::string& name, const ObjectModel& model, double scale, FoundFiles& files);

/// The smallest box around a surface that has vertices.
[[nodiscard]] Cuboid extentOf(const ObjectModel& model);

}  // namespace synthetic_dataset::formats
