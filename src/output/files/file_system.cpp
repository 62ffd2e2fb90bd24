#include "output/files/file_system.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <set>
#include <system_error>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

/// File system types as reported by statfs(2).
constexpr std::array<std::uint32_t, 10> kLocalFileSystems = {
    0xEF53,      // ext2, ext3, ext4
    0x58465342,  // XFS
    0x9123683E,  // Btrfs
    0x2FC12FC1,  // ZFS
    0xF2F52010,  // F2FS
    0xCA451A4E,  // bcachefs
    0x52654973,  // ReiserFS
    0x01021994,  // tmpfs
    0x858458F6,  // ramfs
    0x794C7630,  // overlayfs, used by containers
};

}  // namespace

void syncFileSystems(const std::vector<std::string>& folders) {
  std::set<dev_t> done;
  for (const std::string& folder : folders) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    int failure = descriptor < 0 ? errno : 0;
    struct stat status = {};
    if (failure == 0 && ::fstat(descriptor, &status) != 0) failure = errno;
    // One call per disk instead of one per file: a batch has several hundred files.
    if (failure == 0 && done.insert(status.st_dev).second && ::syncfs(descriptor) != 0) {
      failure = errno;
    }
    if (descriptor >= 0) ::close(descriptor);
    if (failure != 0) {
      throw Error("what was written to '" + folder +
                  "' cannot be flushed to the disk: " + std::generic_category().message(failure));
    }
  }
}

bool isOnLocalDisk(const std::string& folder) {
  struct statfs status = {};
  if (::statfs(folder.c_str(), &status) != 0) return false;
  const auto type = static_cast<std::uint32_t>(status.f_type);
  return std::find(kLocalFileSystems.begin(), kLocalFileSystems.end(), type) !=
         kLocalFileSystems.end();
}

}  // namespace synthetic_dataset::output
