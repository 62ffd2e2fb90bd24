#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace synthetic_dataset::base {

/// The names as "odom, base_link", for messages.
/// @param most  how many are named; the rest are counted: "odom, base_link and 3 more"
[[nodiscard]] std::string listed(const std::vector<std::string>& names,
                                 std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace synthetic_dataset::base
