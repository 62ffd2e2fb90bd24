#include "reference/reference_folder.h"

#include <cstdlib>
#include <stdexcept>

namespace synthetic_dataset::test {

std::filesystem::path referenceFolder() {
  const char* folder = std::getenv("SYNTHETIC_DATASET_REFERENCE");
  if (folder == nullptr) throw std::runtime_error("SYNTHETIC_DATASET_REFERENCE is not set");
  return folder;
}

}  // namespace synthetic_dataset::test
