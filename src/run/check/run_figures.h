#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "run/check/finding.h"
#include "run/setup/run_setup.h"

namespace synthetic_dataset::run {

/// What a run would take.
struct RunFigures {
  std::int64_t bytes = 0;                 ///< of all scenes' files, as those that were made
  std::optional<std::int64_t> free_disk;  ///< [byte] where the dataset goes; none: not known
  double seconds = 0.0;                   ///< about
  std::int64_t memory = 0;                ///< [byte] at most, of all processes
  std::int64_t memory_limit = 0;          ///< [byte] of the machine or its container
};

/// How much memory this process has taken at most [byte].
[[nodiscard]] std::int64_t peakMemory();

/// What the machine has, or what the process's control group may take [byte].
[[nodiscard]] std::int64_t memoryLimit();

/// What is free for a file in this folder, which need not exist [byte].
[[nodiscard]] std::optional<std::int64_t> freeDisk(const std::string& folder);

/// Whether the disk and the memory are too small.
[[nodiscard]] std::vector<Finding> checkFigures(const RunFigures& figures);

/// The run in lines of text: times, scenes, cameras, formats, splits, and what it takes.
[[nodiscard]] std::vector<std::string> planLines(const RunSetup& setup, const RunFigures& figures);

}  // namespace synthetic_dataset::run
