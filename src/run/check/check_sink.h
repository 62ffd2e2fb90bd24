#pragma once

#include <chrono>
#include <cstdint>
#include <set>
#include <vector>

#include "run/check/scene_statistics.h"
#include "run/scene_sink.h"
#include "run/setup/run_setup.h"

namespace synthetic_dataset::run {

/// Keeps some scenes of a run, with all that is needed to judge them, and writes nothing.
class CheckSink : public SceneSink {
 public:
  /// @param setup  has to outlive this
  /// @param instants  whose scenes are made
  CheckSink(const RunSetup& setup, std::set<std::int64_t> instants);

  /// What the run's writers want, and masks.
  [[nodiscard]] Requirements requirements() const override;
  void begin(const DatasetInfo& /*dataset*/) override {}
  [[nodiscard]] bool wants(std::int64_t scene) const override;

  /// Has the writers turn the scene into files, of which the bytes are counted.
  [[nodiscard]] std::vector<base::Warning> add(const FinishedScene& finished) override;
  void finish(RunEnd /*end*/) override {}

  [[nodiscard]] const std::vector<FinishedScene>& scenes() const { return scenes_; }
  [[nodiscard]] const SceneStatistics& statistics() const { return statistics_; }

  /// The size of all scenes' files [byte].
  [[nodiscard]] std::int64_t bytes() const { return bytes_; }

  /// How long the writers took [s], of each scene.
  [[nodiscard]] const std::vector<double>& writingTimes() const { return writing_times_; }

 private:
  const RunSetup& setup_;
  std::set<std::int64_t> instants_;
  std::vector<FinishedScene> scenes_;
  SceneStatistics statistics_;
  std::int64_t bytes_ = 0;
  std::vector<double> writing_times_;
};

}  // namespace synthetic_dataset::run
