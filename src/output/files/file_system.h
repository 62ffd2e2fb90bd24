#pragma once

#include <string>
#include <vector>

namespace synthetic_dataset::output {

/// Forces what was written so far to the disks on which these folders lie.
/// @throws Error naming the folder whose disk does not take it
void syncDisks(const std::vector<std::string>& folders);

/// Whether a folder lies on a disk of this machine, where processes may share memory through files;
/// file systems that are not known count as somebody else's (NFS, Lustre, FUSE, ...).
[[nodiscard]] bool isOnLocalDisk(const std::string& folder);

}  // namespace synthetic_dataset::output
