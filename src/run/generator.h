#pragma once

#include <memory>
#include <string>
#include <vector>

#include "run/reporter.h"
#include "run/run_summary.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// Makes a dataset: sets up a run and passes its scenes to a DatasetSink.
///
/// Needs no ROS master. OpenGL belongs to the thread that makes the generator; use it from there.
class Generator {
 public:
  /// Prepares everything up to the first scene.
  /// @param parameters  as documented in config/params.yaml
  /// @param reporter  must outlive the generator
  /// @param plugin_xml_files  where to look for writers; if empty, all that installed packages
  ///     export
  /// @throws ErrorList with every error that can be found before the first scene; the disk is then
  ///     unchanged
  Generator(const Value& parameters, Reporter& reporter,
            const std::vector<std::string>& plugin_xml_files = {});
  ~Generator();
  Generator(const Generator&) = delete;
  Generator& operator=(const Generator&) = delete;

  /// Makes all scenes and finishes the datasets.
  /// @throws Error if a scene cannot be made or written; finished scenes stay valid
  RunSummary run();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::run
