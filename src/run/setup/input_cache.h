#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "base/stages.h"
#include "output/manifest/run_description.h"
#include "run/setup/file_stamps.h"
#include "run/setup/recording_cache.h"
#include "run/setup/world_files.h"

namespace synthetic_dataset::run {

/// Inputs of a run that take long to read: worlds with meshes and pictures, recordings, digests. A
/// second run that is set up with the same cache does not read unchanged inputs again, and receives
/// exactly what it would have read.
class InputCache {
 public:
  /// @param on_stage  called at the start of a step that may take long
  explicit InputCache(base::OnStage on_stage = base::ignoreStage) : worlds(std::move(on_stage)) {}

  WorldCache worlds;
  RecordingCache recordings;

  /// Sizes and digests of the files from which a dataset is made.
  /// @throws Error naming a file that cannot be read
  [[nodiscard]] std::map<std::string, output::RunDescription::Input> describe(
      const std::set<std::string>& files);

 private:
  struct Described {
    FileStamps stamps;
    output::RunDescription::Input input;
  };

  std::map<std::string, Described> described_;
};

}  // namespace synthetic_dataset::run
