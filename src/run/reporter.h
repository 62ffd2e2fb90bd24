#pragma once

#include <cstdint>
#include <string>

namespace synthetic_dataset {

/// Where a run tells what happens: rosconsole and a terminal in the node, nothing in tests.
class Reporter {
 public:
  Reporter() = default;
  Reporter(const Reporter&) = delete;
  Reporter& operator=(const Reporter&) = delete;
  virtual ~Reporter() = default;

  virtual void info(const std::string& /*message*/) {}
  virtual void warning(const std::string& /*message*/) {}

  /// Before the first scene, and after each.
  virtual void progress(std::int64_t /*scenes_done*/, std::int64_t /*scenes*/) {}

  /// Asked before each scene: the user wants the run to end (Ctrl-C).
  [[nodiscard]] virtual bool stopRequested() const { return false; }
};

}  // namespace synthetic_dataset
