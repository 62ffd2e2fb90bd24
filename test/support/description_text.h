#pragma once

#include <string>

#include "world/description.h"

namespace synthetic_dataset::test {

/// All that a description says of models, lights and cameras, a line each, for comparing two: of
/// meshes how many vertices they have and where those are together.
[[nodiscard]] std::string textOf(const world::Description& description);

}  // namespace synthetic_dataset::test
