#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "run/scene_sink.h"

namespace synthetic_dataset::test {

/// Keeps the scenes that it receives.
struct FakeSceneSink : run::SceneSink {
  [[nodiscard]] Requirements requirements() const override { return required; }
  void begin(const DatasetInfo& info) override { dataset = info; }
  [[nodiscard]] bool wants(std::int64_t scene) const override { return is_wanted(scene); }
  [[nodiscard]] std::vector<base::Warning> add(const run::FinishedScene& finished) override {
    on_add(finished);
    scenes.push_back(finished);
    return warnings;
  }
  void finish(run::RunEnd how) override { end = how; }

  // How it answers.
  Requirements required;
  std::function<bool(std::int64_t scene)> is_wanted = [](std::int64_t) { return true; };
  std::function<void(const run::FinishedScene&)> on_add = [](const run::FinishedScene&) {
  };                                    ///< may throw
  std::vector<base::Warning> warnings;  ///< about each scene

  // What it received.
  std::optional<DatasetInfo> dataset;
  std::vector<run::FinishedScene> scenes;
  std::optional<run::RunEnd> end;
};

}  // namespace synthetic_dataset::test
