#include "synthetic_dataset/output.h"

namespace synthetic_dataset {
inline namespace v2 {

// Out of line: one home for the vtables, so that casts work across plugin libraries.
SceneOutput::~SceneOutput() = default;
SceneRecords::~SceneRecords() = default;
DatasetOutput::~DatasetOutput() = default;

}  // namespace v2
}  // namespace synthetic_dataset
