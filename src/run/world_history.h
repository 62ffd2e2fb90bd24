#pragma once

#include <map>
#include <optional>
#include <vector>

#include "synthetic_dataset/pose.h"
#include "world/world.h"

namespace synthetic_dataset::run {

/// How a motion's world stood at each of its times. What moves of itself depends on all that was
/// before, so that a scene late in a recording waits until physics has come there; with the history
/// of a run that moved alike, the world is shown at any time at once.
class WorldHistory {
 public:
  struct Moment {
    std::vector<Pose> X_WM;                              ///< of the props
    std::vector<std::optional<world::ObjectPose>> X_WO;  ///< of all objects' variants
  };

  /// Whether it has come as far as `time`.
  [[nodiscard]] bool reaches(Stamp time) const {
    return !moments_.empty() && moments_.rbegin()->first >= time;
  }

  /// The world at a time for which it was added; null for others.
  [[nodiscard]] const Moment* find(Stamp time) const {
    const auto found = moments_.find(time);
    return found == moments_.end() ? nullptr : &found->second;
  }

  void add(Stamp time, Moment moment) { moments_.insert_or_assign(time, std::move(moment)); }

 private:
  std::map<Stamp, Moment> moments_;
};

}  // namespace synthetic_dataset::run
