#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "run/check/finding.h"
#include "run/setup/run_setup.h"

namespace synthetic_dataset::run {

/// The resources that a run would take.
struct RunFigures {
  std::int64_t bytes = 0;                 ///< of all scenes' files, extrapolated from those made
  std::optional<std::int64_t> free_disk;  ///< [byte] where the dataset goes; nothing: not known
  double seconds = 0.0;                   ///< about
  std::int64_t memory = 0;                ///< [byte] peak, of all processes
  std::int64_t memory_limit = 0;          ///< [byte] of the machine or its container
};

/// The peak memory of this process [byte].
[[nodiscard]] std::int64_t peakMemory();

/// The memory that the machine has, or that the process's control group may use [byte].
[[nodiscard]] std::int64_t memoryLimit();

/// The disk space available to files in this folder, which need not exist [byte].
[[nodiscard]] std::optional<std::int64_t> freeDisk(const std::string& folder);

/// Reports a disk or memory that is too small.
[[nodiscard]] std::vector<Finding> checkFigures(const RunFigures& figures);

/// The run in lines of text: times, scenes, cameras, formats, splits, and the resources it takes.
[[nodiscard]] std::vector<std::string> planLines(const RunSetup& setup, const RunFigures& figures);

}  // namespace synthetic_dataset::run
