#include "synthetic_dataset/output.h"

#include <ostream>

namespace synthetic_dataset {
inline namespace v2 {

// Out of line: one home for the vtables, so that casts work across plugin libraries.
SceneOutput::~SceneOutput() = default;
SceneRecords::~SceneRecords() = default;
DatasetOutput::~DatasetOutput() = default;

void DatasetOutput::addText(const std::string& path, const std::string& text) {
  addFile(path, [&](std::ostream& stream) { stream << text; });
}

}  // namespace v2
}  // namespace synthetic_dataset
