#pragma once

#include <vector>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::config {

/// The settings of each run: of one or, with `twin/output: both`, of two, one for the recorded
/// pictures and one for rendered ones of the same instants. Their datasets are in `real` and
/// `synthetic` below output_folder; `effects` apply to the rendered pictures.
/// @throws ErrorList if such settings name folders that the two runs would share
[[nodiscard]] std::vector<Value> twinRuns(const Value& settings);

}  // namespace synthetic_dataset::config
