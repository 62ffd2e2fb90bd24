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

/// A dataset on disk, in every format whose writer the run has. Wants what its shard and
/// `only_scenes` ask for, and is not there yet.
class DatasetSink : public SceneSink {
 public:
  /// @param setup  has to outlive this
  explicit DatasetSink(const RunSetup& setup) : setup_(setup), statistics_(setup.config.labels) {}

  [[nodiscard]] Requirements requirements() const override;

  /// Opens the output, which may remove an earlier dataset or go on with it.
  /// @throws ErrorList with all that prevents it; the disk is as it was then
  void begin(const DatasetInfo& dataset) override;

  [[nodiscard]] bool wants(std::int64_t scene) const override;
  [[nodiscard]] std::vector<base::Warning> add(const FinishedScene& finished) override;

  /// Writes the files of the dataset as a whole and completes it, unless scenes are left to others.
  void finish(RunEnd end) override;

  /// How many scenes the dataset, its shard or the choice of `only_scenes` has.
  [[nodiscard]] std::int64_t plannedCount() const;

  /// Statistics of the scenes that this run has made.
  [[nodiscard]] const SceneStatistics& statistics() const { return statistics_; }

  /// What is there; after `begin`.
  [[nodiscard]] const output::DatasetStore& store() const { return *store_; }

 private:
  [[nodiscard]] bool isAskedFor(std::int64_t instant) const;
  [[nodiscard]] std::int64_t cameraCount() const;

  const RunSetup& setup_;
  SceneStatistics statistics_;
  std::unique_ptr<output::DatasetStore> store_;
};

}  // namespace synthetic_dataset::run
