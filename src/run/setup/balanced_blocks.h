#pragma once

#include <cstdint>
#include <vector>

#include "config/config.h"
#include "run/setup/expected_labels.h"

namespace synthetic_dataset::run {

/// Divides a recording's times into blocks so that each split has labels of each class, if
/// possible, and roughly its share of them: the smaller splits choose first. A split may receive
/// several blocks if a single one would lack a class.
/// @param labels  expected at each time
/// @return the index of the share to which each time goes
[[nodiscard]] std::vector<std::uint8_t> balancedBlocks(const config::SplitConfig& config,
                                                       const std::vector<ClassCounts>& labels);

}  // namespace synthetic_dataset::run
