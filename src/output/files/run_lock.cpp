#include "output/files/run_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

/// Whether the open file is still the one with this name: the previous holder of the lock may have
/// removed it between our opening and our locking.
bool isFileOfName(int descriptor, const std::string& name) {
  struct stat opened = {};
  struct stat named = {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(name.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace

std::string RunLock::fileOf(const std::string& manifest) {
  const std::filesystem::path path(manifest);
  return (path.parent_path() / ("." + path.filename().string() + ".lock")).string();
}

bool RunLock::isHeld(const std::string& manifest) {
  const int descriptor = ::open(fileOf(manifest).c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool is_held = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return is_held;
}

RunLock::RunLock(const std::string& manifest) : file_(fileOf(manifest)) {
  while (true) {
    descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      throw Error("cannot make '" + file_ + "': " + std::generic_category().message(errno));
    }
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      const int failure = errno;
      ::close(descriptor_);
      if (failure == EWOULDBLOCK) {
        throw Error("another run is writing the dataset of '" + manifest +
                    "'; wait for its end, or choose another output_folder");
      }
      throw Error("cannot lock '" + file_ + "': " + std::generic_category().message(failure));
    }
    if (isFileOfName(descriptor_, file_)) return;
    ::close(descriptor_);
  }
}

RunLock::~RunLock() {
  ::unlink(file_.c_str());  // while it is still locked, so it cannot be another run's
  ::close(descriptor_);
}

}  // namespace synthetic_dataset::output
