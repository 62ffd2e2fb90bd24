#pragma once

#include <optional>
#include <string>
#include <vector>

#include "run/check/finding.h"
#include "run/check/run_figures.h"
#include "run/check/split_checks.h"
#include "run/check/variety_checks.h"
#include "run/reporter.h"
#include "run/scene_sink.h"
#include "run/setup/run_setup.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// What a run would be, and what is odd about it.
struct RunCheck {
  RunSetup setup;
  std::vector<FinishedScene> scenes;  ///< some of the run's, spread over it
  RunFigures figures;
  std::optional<SceneVariety> variety;  ///< of these scenes, if they have labels
  std::vector<SplitLabels> splits;      ///< what each split would have; none: not known
  std::vector<Finding> findings;
};

/// Sets a run up, makes some nine of its scenes and judges them. Writes nothing.
///
/// OpenGL belongs to the calling thread.
/// @param reporter  gets what the scenes warn of
/// @throws ErrorList with all that keeps the run from beginning
/// @throws Error when a scene cannot be made
[[nodiscard]] RunCheck checkRun(const Value& parameters, Reporter& reporter,
                                const std::vector<std::string>& plugin_xml_files = {});

/// The same of a run that is set up and has made no scene yet.
[[nodiscard]] RunCheck checkRun(RunSetup setup, Reporter& reporter);

}  // namespace synthetic_dataset::run
