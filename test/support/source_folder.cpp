#include "support/source_folder.h"

namespace synthetic_dataset::test {

std::string sourceFolder() { return SYNTHETIC_DATASET_SOURCE_DIR; }

}  // namespace synthetic_dataset::test
