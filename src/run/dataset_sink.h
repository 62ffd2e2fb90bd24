#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "output/dataset_store.h"
#include "run/check/scene_statistics.h"
#include "run/scene_sink.h"
#include "run/setup/run_setup.h"

namespace synthetic_dataset::run {

/// A dataset on disk, in the formats of all the run's writers. Wants the scenes that its shard and
/// `only_scenes` ask for and that do not exist yet.
class DatasetSink : public SceneSink {
 public:
  /// @param setup  must outlive this
  explicit DatasetSink(const RunSetup& setup) : setup_(setup), statistics_(setup.config.labels) {}

  [[nodiscard]] Requirements requirements() const override;

  /// Opens the output, which may remove or continue an earlier dataset.
  /// @throws ErrorList with everything that prevents it; the disk is then unchanged
  void begin(const DatasetInfo& dataset) override;

  [[nodiscard]] bool wants(std::int64_t scene) const override;
  [[nodiscard]] std::vector<base::Warning> add(const FinishedScene& finished) override;

  /// Writes the files that describe the whole dataset and completes it, unless other runs still
  /// have scenes to make.
  void finish(RunEnd end) override;

  /// The number of scenes in the dataset, in its shard, or chosen by `only_scenes`.
  [[nodiscard]] std::int64_t plannedCount() const;

  /// Statistics of the scenes that this run has made.
  [[nodiscard]] const SceneStatistics& statistics() const { return statistics_; }

  /// The dataset's files; call after `begin`.
  [[nodiscard]] const output::DatasetStore& store() const { return *store_; }

 private:
  [[nodiscard]] bool isAskedFor(std::int64_t instant) const;
  [[nodiscard]] std::int64_t cameraCount() const;

  const RunSetup& setup_;
  SceneStatistics statistics_;
  std::unique_ptr<output::DatasetStore> store_;
};

}  // namespace synthetic_dataset::run
