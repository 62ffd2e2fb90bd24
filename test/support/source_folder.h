#pragma once

#include <string>

namespace synthetic_dataset::test {

/// The repository's root, wherever a test is run from.
[[nodiscard]] std::string sourceFolder();

}  // namespace synthetic_dataset::test
