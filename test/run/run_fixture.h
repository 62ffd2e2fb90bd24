#pragma once

#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "run/reporter.h"
#include "run/run_summary.h"
#include "support/tiny_run.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::test {

/// What a run of some parameters writes, or says when it may not begin.
class RunFixture : public ::testing::Test {
 protected:
  RunFixture();

  /// Runs with the parameters.
  run::RunSummary generate() const;
  run::RunSummary generate(run::Reporter& reporter) const;

  /// Every file of the dataset that is there, by its relative path.
  [[nodiscard]] std::map<std::string, std::string> files() const;

  /// Removes what is there, runs, and reads all files.
  std::map<std::string, std::string> filesAnew() const;

  /// All that is found before the first scene.
  [[nodiscard]] std::vector<std::string> errors() const;

  TinyRun run;
  Value::Map parameters = run.parameters();
  const std::string folder = (run.folder() / "out").string();  ///< where the dataset goes
};

}  // namespace synthetic_dataset::test
