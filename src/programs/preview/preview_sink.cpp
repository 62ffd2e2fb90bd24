#include "programs/preview/preview_sink.h"

#include <utility>

namespace synthetic_dataset::programs {

PreviewSink::PreviewSink(PreviewControl& control, std::int64_t first_instant,
                         const Requirements& requirements, std::function<void(const Scene&)> show)
    : control_(control),
      first_instant_(first_instant),
      requirements_(requirements),
      show_(std::move(show)) {}

void PreviewSink::begin(const DatasetInfo& dataset) {
  camera_count_ = static_cast<std::int64_t>(dataset.cameras.size());
}

bool PreviewSink::wants(std::int64_t scene) const {
  return scene / camera_count_ >= first_instant_;
}

std::vector<base::Warning> PreviewSink::add(const run::FinishedScene& finished) {
  if (control_.awaitTurn(finished.scene.instant)) show_(finished.scene);
  return {};
}

}  // namespace synthetic_dataset::programs
