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

/// Runs with parameters, and reads what they write or the errors with which they refuse to begin.
class RunFixture : public ::testing::Test {
 protected:
  RunFixture();

  /// Runs with the parameters.
  run::RunSummary generate() const;
  run::RunSummary generate(run::Reporter& reporter) const;

  /// Every file of the existing dataset, by its relative path.
  [[nodiscard]] std::map<std::string, std::string> files() const;

  /// Removes the existing dataset, runs, and reads all files.
  std::map<std::string, std::string> filesAnew() const;

  /// The errors found before the first scene.
  [[nodiscard]] std::vector<std::string> errors() const;

  TinyRun run;
  Value::Map parameters = run.parameters();
  const std::string folder = (run.folder() / "out").string();  ///< where the dataset goes
};

}  // namespace synthetic_dataset::test
