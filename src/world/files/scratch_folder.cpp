#include "world/files/scratch_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "synthetic_dataset/errors.h"
#include "world/files/text.h"

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

fs::path systemFolder() {
  std::error_code error;
  fs::path folder = fs::temp_directory_path(error);
  if (!error) return folder;
  throw Error("the folder for temporary files (TMPDIR, else /tmp) is not there: " +
              error.message());
}

int opened(const fs::path& folder) {
  return open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

/// Whether a path still leads to what has been opened.
bool isStill(const fs::path& folder, int open_folder) {
  struct stat there {};
  struct stat here {};
  return stat(folder.c_str(), &there) == 0 && fstat(open_folder, &here) == 0 &&
         there.st_ino == here.st_ino && there.st_dev == here.st_dev;
}

/// Whether nobody has a folder any more that this user's process made. It is locked then.
bool isAbandoned(int open_folder) {
  struct stat here {};
  return fstat(open_folder, &here) == 0 && here.st_uid == geteuid() &&
         flock(open_folder, LOCK_EX | LOCK_NB) == 0;
}

/// What cannot be looked at or removed stays.
void removeAbandoned(const fs::path& system_folder, const std::string& name) {
  std::error_code error;
  for (fs::directory_iterator entry(system_folder, error); !error && entry != fs::end(entry);
       entry.increment(error)) {
    if (!startsWith(entry->path().filename().string(), name)) continue;
    const int folder = opened(entry->path());
    if (folder < 0) continue;
    std::error_code ignored;
    if (isAbandoned(folder)) fs::remove_all(entry->path(), ignored);
    close(folder);
  }
}

}  // namespace

ScratchFolder::ScratchFolder(const std::string& name) {
  const fs::path system_folder = systemFolder();
  removeAbandoned(system_folder, name);
  do {
    if (lock_ >= 0) close(lock_);
    std::string path = (system_folder / name).string() + "XXXXXX";
    if (mkdtemp(path.data()) == nullptr) {
      throw Error("'" + system_folder.string() +
                  "': no folder for temporary files can be made in it: " + std::strerror(errno));
    }
    path_ = path;
    lock_ = opened(path_);
    // Until it is locked, another process may take it for abandoned. Where no locks are to be had,
    // none does.
    if (lock_ >= 0) flock(lock_, LOCK_EX);
  } while (lock_ >= 0 && !isStill(path_, lock_));
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (lock_ >= 0) close(lock_);
}

}  // namespace synthetic_dataset::world
