#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/stages.h"
#include "config/config.h"
#include "output/manifest/run_description.h"
#include "output/writers/writer_host.h"
#include "run/check/finding.h"
#include "run/setup/motion_setup.h"
#include "run/setup/split_plan.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

class InputCache;

/// Everything that a run needs, checked and ready for the first scene.
struct RunSetup {
  config::Config config;             ///< its dataset-wide settings are the same for every motion
  std::vector<MotionSetup> motions;  ///< at least one, in the order of their scenes
  std::unique_ptr<SplitPlan> splits;
  std::unique_ptr<output::WriterHost> writers;
  output::RunDescription description;       ///< for the manifest; includes the warnings
  base::Diagnostics diagnostics;            ///< warnings and notes
  std::vector<Finding> findings;            ///< oddities, of which `diagnostics` warns too
  std::vector<std::string> defaults_taken;  ///< "parameter: value"

  /// The number of instants of all motions together.
  [[nodiscard]] std::int64_t instantCount() const;
};

/// Settings with all short forms expanded: `count` of objects, presets. A run uses these, and the
/// manifest records them.
[[nodiscard]] Value spelledOut(const Value& parameters);

/// Reads parameters, recordings, worlds, cameras and writers. Writes nothing.
/// @param on_stage  called at the start of a step that may take long
/// @throws ErrorList with everything that is wrong
[[nodiscard]] RunSetup setUpRun(const Value& parameters,
                                const std::vector<std::string>& plugin_xml_files,
                                const base::OnStage& on_stage = base::ignoreStage);

/// The same, but faster if an earlier run has read inputs that are unchanged.
/// @param inputs  of earlier runs; receives what is read for this one
[[nodiscard]] RunSetup setUpRun(const Value& parameters, InputCache& inputs,
                                const std::vector<std::string>& plugin_xml_files,
                                const base::OnStage& on_stage = base::ignoreStage);

}  // namespace synthetic_dataset::run
