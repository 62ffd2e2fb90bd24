#pragma once

#include <vector>

namespace synthetic_dataset::render {

/// Which links take part in a pass: one flag a link, in the world's order.
using LinkSelection = std::vector<bool>;

}  // namespace synthetic_dataset::render
