#pragma once

#include <string>

namespace synthetic_dataset::output {

/// Keeps a second run away from a manifest for as long as it lives, and no longer than its process:
/// a lock of flock(2) on a hidden file beside the manifest.
class RunLock {
 public:
  /// @param manifest  its absolute path; its folder exists
  /// @throws Error when another run has it, or the lock's file cannot be made
  explicit RunLock(const std::string& manifest);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  /// Whether a run has it just now.
  [[nodiscard]] static bool isHeld(const std::string& manifest);

  /// Where the lock of a manifest lies.
  [[nodiscard]] static std::string fileOf(const std::string& manifest);

 private:
  std::string file_;
  int descriptor_ = -1;
};

}  // namespace synthetic_dataset::output
