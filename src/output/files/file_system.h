#pragma once

#include <string>

namespace synthetic_dataset::output {

/// Whether a folder lies on a disk of this machine, where processes may share memory through files;
/// file systems that are not known count as somebody else's (NFS, Lustre, FUSE, ...).
[[nodiscard]] bool isOnLocalDisk(const std::string& folder);

}  // namespace synthetic_dataset::output
