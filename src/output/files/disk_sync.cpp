#include "output/files/disk_sync.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <set>
#include <system_error>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {

void syncDisks(const std::vector<std::string>& folders) {
  std::set<dev_t> done;
  for (const std::string& folder : folders) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    int failure = descriptor < 0 ? errno : 0;
    struct stat status = {};
    if (failure == 0 && ::fstat(descriptor, &status) != 0) failure = errno;
    // One call a disk instead of one a file: a batch has some hundred files.
    if (failure == 0 && done.insert(status.st_dev).second && ::syncfs(descriptor) != 0) {
      failure = errno;
    }
    if (descriptor >= 0) ::close(descriptor);
    if (failure != 0) {
      throw Error("what was written to '" + folder +
                  "' cannot be forced to the disk: " + std::generic_category().message(failure));
    }
  }
}

}  // namespace synthetic_dataset::output
