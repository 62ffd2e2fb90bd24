#pragma once

#include <filesystem>

namespace synthetic_dataset::test {

/// The folder with the reference data: the environment's SYNTHETIC_DATASET_REFERENCE.
[[nodiscard]] std::filesystem::path referenceFolder();

}  // namespace synthetic_dataset::test
