#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "output/manifest/shard.h"

namespace synthetic_dataset {

/// Which of a run's instants this process has to make: those of its shard, and of those that are
/// asked for, that are not there yet.
class WorkPlan {
 public:
  /// @param shard  nothing: all of the run
  /// @param only  the instants that are to be made of it; empty: all
  /// @param is_there  whether a scene, by its index, is in the dataset
  WorkPlan(std::int64_t instant_count, std::int64_t camera_count,
           const std::optional<output::Shard>& shard, const std::set<std::int64_t>& only,
           const std::function<bool(std::int64_t scene)>& is_there);

  /// Whether a scene of this instant is to be made.
  [[nodiscard]] bool wants(std::int64_t instant) const {
    return wanted_[static_cast<std::size_t>(instant)];
  }

  /// Whether a scene was not there at the start.
  [[nodiscard]] bool lacks(std::int64_t scene) const {
    return !there_[static_cast<std::size_t>(scene)];
  }

  /// Just behind the last instant before `end` of which a scene is to be made; 0 without one.
  [[nodiscard]] std::int64_t endOfWork(std::int64_t end) const;

  /// Of the run or its shard: how many scenes it has, and how many of them are to be made.
  [[nodiscard]] std::int64_t sceneCount() const { return scene_count_; }
  [[nodiscard]] std::int64_t missingCount() const { return missing_count_; }

 private:
  std::vector<bool> wanted_;  ///< by instant
  std::vector<bool> there_;   ///< by scene
  std::int64_t scene_count_ = 0;
  std::int64_t missing_count_ = 0;
};

}  // namespace synthetic_dataset
