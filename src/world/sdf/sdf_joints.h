#pragma once

#include <string>

#include "world/sdf/model_source.h"
#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// Hangs the links of a model on one another as its joints say. A link has one parent; where joints
/// close a loop, the first of them counts.
/// @param source  its own joints alone are read
/// @param prefix  of its links in `model`: "" or "child::"
/// @return whether a joint holds one of the links to the world
bool readJoints(const ModelSource& source, const std::string& prefix, SdfReading& reading,
                Model& model);

}  // namespace synthetic_dataset::world
