#pragma once

#include <string>
#include <vector>

namespace synthetic_dataset::output {

/// Forces what was written so far to the disks on which these folders lie.
/// @throws Error naming the folder whose disk does not take it
void syncDisks(const std::vector<std::string>& folders);

}  // namespace synthetic_dataset::output
