#pragma once

#include <map>
#include <string>
#include <vector>

#include "run/reporter.h"
#include "run/run_summary.h"
#include "support/tiny_run.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::test {

/// Stops a run after a number of scenes.
class StoppingReporter : public run::Reporter {
 public:
  explicit StoppingReporter(std::int64_t scenes) : scenes_(scenes) {}

  void progress(std::int64_t done, std::int64_t /*all*/) override { done_ = done; }
  [[nodiscard]] bool stopRequested() const override { return done_ >= scenes_; }

 private:
  std::int64_t scenes_;
  std::int64_t done_ = 0;
};

/// A small run in which much goes on: a ball that falls, two cameras, noise, masks by background
/// subtraction, optical flow, which looks at the next scene, and formats with dataset-wide files
/// and links to files of scenes. All tests use the same folder, one after another, as paths of
/// inputs are part of a dataset.
class AllAtOnceRun {
 public:
  AllAtOnceRun();

  [[nodiscard]] std::string folder() const { return (tiny_.folder() / "out").string(); }
  [[nodiscard]] std::string input(const std::string& name) const {
    return (tiny_.folder() / name).string();
  }

  /// Runs with these parameters; the dataset goes to `folder`.
  run::RunSummary run(run::Reporter& reporter, const std::string& folder) const;
  run::RunSummary run() const;

  /// The files of a run of all scenes with these parameters, which leaves nothing behind. They are
  /// made once for all tests that have the same parameters and inputs.
  [[nodiscard]] const std::map<std::string, std::string>& unbroken() const;

  /// The errors with which the run refuses to begin or to go on.
  [[nodiscard]] std::vector<std::string> errors() const;

  /// Makes a shard.
  run::RunSummary runShard(int index, int count, const std::string& folder) const;

  /// Every file below a dataset's folder, by its relative path.
  [[nodiscard]] static std::map<std::string, std::string> files(const std::string& folder);

  /// Expects these files in `folder`, and no others.
  void expectFiles(const std::map<std::string, std::string>& expected) const;

  Value::Map parameters;

 private:
  TinyRun tiny_;
};

}  // namespace synthetic_dataset::test
