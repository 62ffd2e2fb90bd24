#include "run/dataset_sink.h"

#include "run/label_counts.h"
#include "run/open_output.h"

namespace synthetic_dataset::run {

Requirements DatasetSink::requirements() const { return setup_.writers->requirements(); }

void DatasetSink::begin(const DatasetInfo& /*dataset*/) { store_ = openOutput(setup_); }

bool DatasetSink::wants(std::int64_t scene) const {
  return isAskedFor(scene / cameraCount()) && !store_->wasComplete() && !store_->hasScene(scene);
}

bool DatasetSink::isAskedFor(std::int64_t instant) const {
  const config::Config& config = setup_.config;
  const auto& shard = config.output.shard;
  if (shard && !belongsTo(*shard, instant, setup_.instantCount())) return false;
  return config.only_scenes.empty() || config.only_scenes.count(instant) != 0;
}

std::int64_t DatasetSink::plannedCount() const {
  std::int64_t instants = 0;
  for (std::int64_t instant = 0; instant < setup_.instantCount(); ++instant) {
    if (isAskedFor(instant)) ++instants;
  }
  return instants * cameraCount();
}

std::int64_t DatasetSink::cameraCount() const {
  return static_cast<std::int64_t>(setup_.config.cameras.size());
}

std::vector<base::Warning> DatasetSink::add(const FinishedScene& finished) {
  if (finished.is_left_out) {
    store_->recordSkippedScene(finished.facts);
    return {};
  }
  output::WriterHost::SceneResult written = setup_.writers->writeScene(finished.scene);
  written.files.recorded = {finished.scene.image, finished.image_file};
  std::vector<base::Warning> warnings;
  for (const std::string& warning : written.warnings) warnings.push_back({warning});
  base::SceneFacts facts = finished.facts;
  facts.warnings.insert(facts.warnings.end(), warnings.begin(), warnings.end());
  const std::string& global = setup_.description.global_frame;
  for (const std::string& frame : setup_.writers->requirements().frames) {
    facts.frames.emplace(frame, finished.scene.transform(global, frame));
  }
  store_->commitScene(facts, written.files);
  statistics_.add(finished.scene);
  return warnings;
}

void DatasetSink::finish(RunEnd end) {
  const config::Config& config = setup_.config;
  if (end == RunEnd::kStopped || !config.only_scenes.empty()) {
    store_->flush();
    return;
  }
  // The files that describe the whole dataset are made from all shards when they are merged.
  if (config.output.shard) {
    store_->complete();
    return;
  }
  setup_.writers->finalize(*store_);
  complete(*store_, config.objects);
}

}  // namespace synthetic_dataset::run
