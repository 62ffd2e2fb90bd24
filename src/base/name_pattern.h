#pragma once

#include <string>

namespace synthetic_dataset::base {

/// Whether a name matches a pattern, in which `*` stands for any text and `?` for any character.
[[nodiscard]] bool matchesPattern(const std::string& name, const std::string& pattern);

}  // namespace synthetic_dataset::base
