#pragma once

#include <memory>
#include <string>
#include <vector>

#include "run/reporter.h"
#include "run/run_summary.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// Makes a dataset: sets a run up and gives its scenes to a DatasetSink.
///
/// Needs no ROS master. OpenGL belongs to the thread that makes the generator; use it from there.
class Generator {
 public:
  /// Prepares everything up to the first scene.
  /// @param parameters  as config/params.yaml documents them
  /// @param reporter  has to outlive the generator
  /// @param plugin_xml_files  where to look for writers; empty: all that installed packages export
  /// @throws ErrorList with every error that can be found before the first scene; the disk is as it
  ///     was then
  Generator(const Value& parameters, Reporter& reporter,
            const std::vector<std::string>& plugin_xml_files = {});
  ~Generator();
  Generator(const Generator&) = delete;
  Generator& operator=(const Generator&) = delete;

  /// Makes all scenes and finishes the datasets.
  /// @throws Error when a scene cannot be made or written; what was finished stays valid
  RunSummary run();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::run
