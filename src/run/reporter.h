#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "output/manifest/run_description.h"

namespace synthetic_dataset::run {

/// Where a run reports what happens: rosconsole and a terminal in the node, nothing in tests. Only
/// called from the thread of the run.
class Reporter {
 public:
  Reporter() = default;
  Reporter(const Reporter&) = delete;
  Reporter& operator=(const Reporter&) = delete;
  virtual ~Reporter() = default;

  virtual void info(const std::string& /*message*/) {}
  virtual void warning(const std::string& /*message*/) {}

  /// A start-up step begins that may take long; start-up ends with the first scene.
  virtual void stage(const std::string& /*what*/) {}

  /// Called before the first scene and after each one.
  virtual void progress(std::int64_t /*scenes_done*/, std::int64_t /*scenes*/) {}

  /// Whether the user wants the run to end (Ctrl-C); asked before each scene.
  [[nodiscard]] virtual bool stopRequested() const { return false; }

  /// Reports each kind of warning once; the manifest records how often it occurred.
  void warnOfEachKind(const std::vector<base::Warning>& warnings) {
    for (const base::Warning& each : warnings) {
      if (!reported_kinds_.insert(each.kind).second) continue;
      warning(each.detail.empty() ? each.kind : each.kind + " (" + each.detail + ")");
    }
  }

 private:
  std::set<std::string> reported_kinds_;
};

/// Collects a run's warnings, each kind once.
struct WarningList : Reporter {
  void warning(const std::string& message) override { messages.push_back(message); }

  std::vector<std::string> messages;
};

}  // namespace synthetic_dataset::run
