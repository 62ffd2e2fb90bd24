#pragma once

#include <string>

#include "world/description.h"

namespace synthetic_dataset::test {

/// A description's models, lights and cameras as lines of text, for comparing two descriptions; a
/// mesh is summarized by its numbers of vertices and indices and the sum of its positions.
[[nodiscard]] std::string textOf(const world::Description& description);

}  // namespace synthetic_dataset::test
