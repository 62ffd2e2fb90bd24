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

/// The result of checking a run: what it would be, and what is odd about it.
struct RunCheck {
  RunSetup setup;
  std::vector<FinishedScene> scenes;  ///< a sample spread over the run
  RunFigures figures;
  std::optional<SceneVariety> variety;  ///< of these scenes, if they have labels
  std::vector<SplitLabels> splits;      ///< what each split would have; empty: not known
  std::vector<Finding> findings;
};

/// Sets up a run, makes about nine of its scenes and checks them. Writes nothing.
///
/// The calling thread owns the OpenGL context.
/// @param reporter  receives the scenes' warnings
/// @throws ErrorList with everything that prevents the run from starting
/// @throws Error if a scene cannot be made
[[nodiscard]] RunCheck checkRun(const Value& parameters, Reporter& reporter,
                                const std::vector<std::string>& plugin_xml_files = {});

/// The same for a run that is set up and has made no scene yet.
[[nodiscard]] RunCheck checkRun(RunSetup setup, Reporter& reporter);

}  // namespace synthetic_dataset::run
