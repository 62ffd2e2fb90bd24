#pragma once

#include <string>

namespace synthetic_dataset::output {

/// Keeps a second run away from a manifest as long as this object lives, and never longer than its
/// process: a flock(2) lock on a hidden file beside the manifest.
class RunLock {
 public:
  /// @param manifest  its absolute path; its folder exists
  /// @throws Error if another run holds it, or the lock file cannot be made
  explicit RunLock(const std::string& manifest);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  /// Whether a run holds the lock right now.
  [[nodiscard]] static bool isHeld(const std::string& manifest);

  /// The path of a manifest's lock file.
  [[nodiscard]] static std::string fileOf(const std::string& manifest);

 private:
  std::string file_;
  int descriptor_ = -1;
};

}  // namespace synthetic_dataset::output
