#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "output/dataset_opening.h"
#include "run/check/finding.h"
#include "run/check/run_check.h"
#include "run/check/run_figures.h"
#include "run/setup/run_setup.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// Something about the settings that the user should know.
struct LiveProblem {
  base::Severity severity = base::Severity::kError;
  std::string about;              ///< a setting's full name, an object or a file; empty: the run
  std::vector<std::string> path;  ///< of the setting that it is about; empty if there is none
  std::string found;
  std::string cure = {};  ///< empty if `found` says it
};

/// Describes the run that results from settings.
struct LiveSetup {
  bool ready = false;  ///< whether a run could start
  std::vector<LiveProblem> problems;

  // For a run that could start:
  std::vector<Stamp> stamps;         ///< of its instants
  std::vector<std::string> cameras;  ///< their names
  std::vector<std::string> objects;
  std::int64_t scenes = 0;  ///< over all cameras
  std::vector<SplitInfo> splits;
  std::string output_folder;
  std::optional<RunFigures> figures;  ///< of a run that was checked

  /// The dataset that already exists where the run would write; nothing while a run is writing it.
  std::optional<output::EarlierRun> earlier;
};

/// @param message  "<setting or file>: <found>; <cure>"
[[nodiscard]] LiveProblem problemOf(base::Severity severity, const std::string& message);

[[nodiscard]] LiveProblem problemOf(const Finding& finding);

/// Describes a run that could start.
[[nodiscard]] LiveSetup describeSetup(const RunSetup& setup);

/// The same with all findings of a check.
/// @param warnings  of its scenes
[[nodiscard]] LiveSetup describeCheck(const RunCheck& check,
                                      const std::vector<std::string>& warnings);

/// Adds the dataset that already exists where the run would write, which changes independently of
/// the settings.
void addEarlierRun(const RunSetup& run, LiveSetup& live);

/// Describes what prevents a run from starting.
[[nodiscard]] LiveSetup describeErrors(const ErrorList& errors);

/// For programs.
[[nodiscard]] Value::Map setupValue(const LiveSetup& setup);

/// Severity, about, path, found, cure.
[[nodiscard]] Value problemValue(const LiveProblem& problem);

}  // namespace synthetic_dataset::run
