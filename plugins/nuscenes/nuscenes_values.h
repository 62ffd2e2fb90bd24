#pragma once

#include <memory>

#include "plugins/readback/found_files.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::formats::nuscenes {

/// Holds all values of a dataset in the format against the truth.
[[nodiscard]] std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters,
                                                     const DatasetInfo& dataset);

}  // namespace synthetic_dataset::formats::nuscenes
