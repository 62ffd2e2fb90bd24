#pragma once

#include <string>

namespace synthetic_dataset {

/// An object's folder: its name, or where that cannot be a path one that can. A name with slashes
/// is folders within one another, as it always was.
[[nodiscard]] std::string stvNetFolder(const std::string& name);

}  // namespace synthetic_dataset
