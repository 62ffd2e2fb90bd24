#pragma once

#include <filesystem>
#include <string>

namespace synthetic_dataset::world {

/// A folder for temporary files of this process, in the system's (TMPDIR, else /tmp). It goes with
/// its object; where the process dies first, the next one that makes a folder of the same name
/// removes it.
class ScratchFolder {
 public:
  /// @param name  the beginning of its name; six characters follow
  /// @throws Error if the system's folder is not there or cannot be written
  explicit ScratchFolder(const std::string& name);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;  ///< the folder, open and locked as long as somebody has it
};

}  // namespace synthetic_dataset::world
