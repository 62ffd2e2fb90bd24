#pragma once

#include <string>

#include "world/sdf/model_source.h"
#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// Connects the links of a model as its joints say. A link has one parent; if joints close a loop,
/// the first of them counts.
/// @param source  only its own joints are read
/// @param prefix  of its links' names in `model`: "" or "child::"
/// @return whether a joint attaches one of the links to the world
bool readJoints(const ModelSource& source, const std::string& prefix, SdfReading& reading,
                Model& model);

}  // namespace synthetic_dataset::world
