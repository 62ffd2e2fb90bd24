#pragma once

#include <cstdint>

#include "run/dataset_sink.h"
#include "run/reporter.h"
#include "run/setup/run_setup.h"

namespace synthetic_dataset::run {

/// Reports what a run will make, before its first scene.
/// @param dataset  has begun
/// @param missing_count  how many of its scenes are still to be made
void reportPlan(const RunSetup& setup, const DatasetSink& dataset, std::int64_t missing_count,
                Reporter& reporter);

}  // namespace synthetic_dataset::run
