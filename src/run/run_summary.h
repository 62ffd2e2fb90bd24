#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "run/stage_times.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// What a run made, for the report at its end.
struct RunSummary {
  struct Object {
    std::string name;
    std::int64_t scenes_in_view = 0;   ///< judged by its loose box
    std::int64_t scenes_seen = 0;      ///< with a visible pixel, if these are counted
    std::int64_t scenes_dropped = 0;   ///< in view, but below the thresholds of `labels`
    std::int64_t scenes_counted = 0;   ///< in which its visible pixels were counted
    std::int64_t scenes_labelled = 0;  ///< in which it should have a label

    /// Mean intersection over union of its visible masks by background subtraction and its exact
    /// ones.
    std::optional<double> mask_agreement = std::nullopt;

    bool is_distractor = false;  ///< and so need not be seen anywhere
  };

  bool stopped = false;       ///< ended early because the user asked for it
  bool was_complete = false;  ///< there was nothing to do; everything but `manifest` is empty
  std::int64_t scenes = 0;    ///< made by this run
  double seconds = 0.0;       ///< that these scenes took
  StageTimes times;

  // Totals of the dataset, or of the shard, over all runs that made it.
  std::int64_t dataset_scenes = 0;
  std::int64_t planned_scenes = 0;
  std::int64_t files = 0;
  std::int64_t bytes = 0;
  std::vector<Object> objects;
  std::map<std::string, std::int64_t> warnings;  ///< kind to count
  std::vector<std::string> missing_labels;       ///< messages about them
  std::string manifest;
};

/// The summary as lines of text.
[[nodiscard]] std::vector<std::string> summaryLines(const RunSummary& summary);

/// The summary for programs: scene counts, seconds, bytes, and the counts of each object and
/// warning.
[[nodiscard]] Value::Map summaryValue(const RunSummary& summary);

/// The last line of a finished run: it says what is missing, or that nothing had to be made.
[[nodiscard]] std::string lastLine(const RunSummary& summary);

}  // namespace synthetic_dataset::run
