#pragma once

#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// The formats that a text like docs/formats.md describes, for the page: name, type, what it makes,
/// who reads it, and its settings from the tables of its section.
[[nodiscard]] Value formatList(const std::string& document);

/// docs/formats.md as it was when this program was built.
[[nodiscard]] const std::string& formatsDocument();

}  // namespace synthetic_dataset::programs
