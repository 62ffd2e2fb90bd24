#pragma once

#include <optional>

#include "config/config.h"
#include "run/reporter.h"
#include "run/run_summary.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// A run whose scenes are made by several processes, one shard each, and merged into one dataset,
/// byte for byte that of a single process. Construct it before there are other threads.
class ParallelRun {
 public:
  /// @param settings  all of the run's; errors in them are thrown by make() or, if isPossible() is
  ///     false, by the generator that makes the run instead
  explicit ParallelRun(const Value& settings);

  /// Whether `processes` asks for it, and any dataset that exists is not one that a single process
  /// has to resume.
  [[nodiscard]] bool isPossible() const;

  /// @return run::mergeShards' summary of the complete dataset; nothing if the run was stopped
  /// @throws ErrorList with all that is wrong
  [[nodiscard]] std::optional<run::RunSummary> make(run::Reporter& reporter) const;

 private:
  [[nodiscard]] Value::Map settingsOf(int shard) const;
  [[nodiscard]] bool removeEarlier(run::Reporter& reporter) const;

  Value::Map settings_;
  config::Config config_;  ///< of the first motion
};

}  // namespace synthetic_dataset::programs
