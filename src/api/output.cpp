#include "synthetic_dataset/output.h"

#include <ostream>

namespace synthetic_dataset {
inline namespace v2 {

// Out of line, so that each vtable is in one place and casts work across plugin libraries.
SceneOutput::~SceneOutput() = default;
SceneRecords::~SceneRecords() = default;
DatasetOutput::~DatasetOutput() = default;

void DatasetOutput::addText(const std::string& path, const std::string& text) {
  addFile(path, [&](std::ostream& stream) { stream << text; });
}

}  // namespace v2
}  // namespace synthetic_dataset
