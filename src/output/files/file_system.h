#pragma once

#include <string>
#include <vector>

namespace synthetic_dataset::output {

/// Forces everything written so far to the disks that hold these folders.
/// @throws Error naming the folder whose disk fails
void syncFileSystems(const std::vector<std::string>& folders);

/// Whether a folder is on a local disk of this machine, where processes can share memory through
/// files; unknown file systems count as remote (NFS, Lustre, FUSE, ...).
[[nodiscard]] bool isOnLocalDisk(const std::string& folder);

}  // namespace synthetic_dataset::output
