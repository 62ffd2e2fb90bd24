#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace synthetic_dataset::run {

/// Which scenes of a run are to be made.
class WorkPlan {
 public:
  /// @param camera_count  scenes at each instant
  /// @param is_wanted  whether a scene, by its index, is to be made
  WorkPlan(std::int64_t instant_count, std::int64_t camera_count,
           const std::function<bool(std::int64_t scene)>& is_wanted);

  /// Whether a scene of this instant is to be made.
  [[nodiscard]] bool hasInstant(std::int64_t instant) const;

  [[nodiscard]] bool hasScene(std::int64_t scene) const {
    return wanted_[static_cast<std::size_t>(scene)];
  }

  /// One past the last instant before `end` at which a scene is to be made; 0 if there is none.
  [[nodiscard]] std::int64_t endOfWork(std::int64_t end) const;

  /// How many scenes are to be made.
  [[nodiscard]] std::int64_t sceneCount() const { return scene_count_; }

 private:
  std::int64_t camera_count_;
  std::vector<bool> wanted_;  ///< by scene
  std::int64_t scene_count_ = 0;
};

}  // namespace synthetic_dataset::run
