#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "programs/preview/preview_control.h"
#include "run/scene_sink.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::programs {

/// Shows the scenes of a run from an instant on, each when its turn comes, and writes nothing.
class PreviewSink : public run::SceneSink {
 public:
  /// @param control  has to outlive this
  /// @param show  gets each scene when it is its turn, in the thread that adds it
  PreviewSink(PreviewControl& control, std::int64_t first_instant, const Requirements& requirements,
              std::function<void(const Scene&)> show);

  [[nodiscard]] Requirements requirements() const override { return requirements_; }
  void begin(const DatasetInfo& dataset) override;
  [[nodiscard]] bool wants(std::int64_t scene) const override;
  [[nodiscard]] std::vector<base::Warning> add(const run::FinishedScene& finished) override;
  void finish(run::RunEnd /*end*/) override {}

 private:
  PreviewControl& control_;
  std::int64_t first_instant_;
  Requirements requirements_;
  std::function<void(const Scene&)> show_;
  std::int64_t camera_count_ = 1;
};

}  // namespace synthetic_dataset::programs
