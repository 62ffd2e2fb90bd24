#pragma once

#include <map>
#include <optional>
#include <vector>

#include "synthetic_dataset/pose.h"
#include "world/world.h"

namespace synthetic_dataset::run {

/// The state of a motion's world at each of its times. What moves by physics depends on everything
/// before, so a scene late in a recording has to wait until physics has reached it; with the
/// history of a run that moved identically, the world can be shown at any time immediately.
class WorldHistory {
 public:
  struct Moment {
    std::vector<Pose> X_WM;                              ///< for each prop
    std::vector<std::optional<world::ObjectPose>> X_WO;  ///< for each variant of each object
  };

  /// Whether the history extends to `time`.
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
