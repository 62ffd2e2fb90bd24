#pragma once

#include <cstdint>
#include <vector>

#include "config/config.h"
#include "run/setup/expected_labels.h"

namespace synthetic_dataset::run {

/// Divides a recording's times into blocks so that each split has labels of each class, where that
/// can be, and about its share of them: the smaller splits choose first. A split may have several
/// blocks where one would lack a class.
/// @param labels  of each time
/// @return the index of the share that each time goes to
[[nodiscard]] std::vector<std::uint8_t> balancedBlocks(const config::SplitConfig& config,
                                                       const std::vector<ClassCounts>& labels);

}  // namespace synthetic_dataset::run
