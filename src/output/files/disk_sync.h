#pragma once

#include <string>
#include <vector>

namespace synthetic_dataset::output {

/// How hard a run waits for the disk.
enum class Sync {
  kOff,    ///< never: a power cut may cost anything
  kScene,  ///< after each scene
  kBatch,  ///< after each so many scenes
};

/// Forces what was written so far to the disks on which these folders lie.
/// @throws Error naming the folder whose disk does not take it
void syncDisks(const std::vector<std::string>& folders);

}  // namespace synthetic_dataset::output
