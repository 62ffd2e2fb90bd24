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

/// Everything that a run is made of, checked and ready for the first scene.
struct RunSetup {
  config::Config config;             ///< what holds for the whole dataset is that of every motion
  std::vector<MotionSetup> motions;  ///< at least one, in the order of their scenes
  std::unique_ptr<SplitPlan> splits;
  std::unique_ptr<output::WriterHost> writers;
  output::RunDescription description;       ///< for the manifest; with the warnings
  base::Diagnostics diagnostics;            ///< warnings and notes
  std::vector<Finding> findings;            ///< what is odd, which `diagnostics` warns of, too
  std::vector<std::string> defaults_taken;  ///< "parameter: value"

  /// The times of all motions together.
  [[nodiscard]] std::int64_t instantCount() const;
};

/// Settings with all that short forms stand for: `count` of objects, presets. A run has these; the
/// manifest keeps them.
[[nodiscard]] Value spelledOut(const Value& parameters);

/// Reads parameters, recordings, worlds, cameras and writers. Writes nothing.
/// @param on_stage  called when a step begins that may take long
/// @throws ErrorList with all that is wrong
[[nodiscard]] RunSetup setUpRun(const Value& parameters,
                                const std::vector<std::string>& plugin_xml_files,
                                const base::OnStage& on_stage = base::ignoreStage);

/// The same, quicker where an earlier run has read what is still as it was.
/// @param inputs  of earlier runs; gets what was read for this one
[[nodiscard]] RunSetup setUpRun(const Value& parameters, InputCache& inputs,
                                const std::vector<std::string>& plugin_xml_files,
                                const base::OnStage& on_stage = base::ignoreStage);

}  // namespace synthetic_dataset::run
