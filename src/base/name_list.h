#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace synthetic_dataset::base {

/// "odom, base_link", for messages.
/// @param most  that are named; of the rest their number is given: "odom, base_link and 3 more"
[[nodiscard]] std::string listed(const std::vector<std::string>& names,
                                 std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace synthetic_dataset::base
