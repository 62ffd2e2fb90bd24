#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "run/scene_sink.h"

namespace synthetic_dataset::run {

/// All labels that can be shown.
[[nodiscard]] inline Requirements allLabels() {
  Requirements all;
  all.silhouettes = all.visible_masks = all.visibility = all.keypoint_states = all.depth = true;
  return all;
}

/// Keeps one scene of a run.
class OneSceneSink : public SceneSink {
 public:
  /// @param index  its Scene::index
  explicit OneSceneSink(std::int64_t index, Requirements requirements = allLabels())
      : index_(index), requirements_(std::move(requirements)) {}

  [[nodiscard]] Requirements requirements() const override { return requirements_; }
  void begin(const DatasetInfo& /*dataset*/) override {}
  [[nodiscard]] bool wants(std::int64_t scene) const override { return scene == index_; }
  [[nodiscard]] std::vector<base::Warning> add(const FinishedScene& finished) override {
    scene_ = finished.scene;
    scene_->setTransforms({});  // they need the run
    draws_ = finished.facts.draws;
    return {};
  }
  void finish(RunEnd /*end*/) override {}

  /// The scene, once it has been made.
  [[nodiscard]] const std::optional<Scene>& scene() const { return scene_; }

  /// The randomization draws made for it.
  [[nodiscard]] const std::vector<base::DrawFacts>& draws() const { return draws_; }

 private:
  std::int64_t index_;
  Requirements requirements_;
  std::optional<Scene> scene_;
  std::vector<base::DrawFacts> draws_;
};

}  // namespace synthetic_dataset::run
