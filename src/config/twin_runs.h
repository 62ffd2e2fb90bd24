#pragma once

#include <vector>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::config {

/// The runs that settings stand for: one, or with `twin/output: both` two, that of the recorded
/// pictures and that of the drawn ones of the same instants. Their datasets are in `real` and
/// `synthetic` of output_folder; `effects` are those of the drawn ones.
/// @throws ErrorList where such settings name folders in which the two would meet
[[nodiscard]] std::vector<Value> twinRuns(const Value& settings);

}  // namespace synthetic_dataset::config
