#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "run/scene_sink.h"

namespace synthetic_dataset::run {

/// Keeps one scene of a run with all labels that can be shown.
class OneSceneSink : public SceneSink {
 public:
  /// @param index  its Scene::index
  explicit OneSceneSink(std::int64_t index) : index_(index) {}

  [[nodiscard]] Requirements requirements() const override {
    Requirements all;
    all.silhouettes = all.visible_masks = all.visibility = all.keypoint_states = all.depth = true;
    return all;
  }
  void begin(const DatasetInfo& /*dataset*/) override {}
  [[nodiscard]] bool wants(std::int64_t scene) const override { return scene == index_; }
  [[nodiscard]] std::vector<output::Warning> add(const FinishedScene& finished) override {
    scene_ = finished.scene;
    scene_->setTransforms({});  // they need the run
    return {};
  }
  void finish(RunEnd /*end*/) override {}

  /// The scene, once it was made.
  [[nodiscard]] const std::optional<Scene>& scene() const { return scene_; }

 private:
  std::int64_t index_;
  std::optional<Scene> scene_;
};

}  // namespace synthetic_dataset::run
