#include "run/work_plan.h"

namespace synthetic_dataset::run {

WorkPlan::WorkPlan(std::int64_t instant_count, std::int64_t camera_count,
                   const std::function<bool(std::int64_t scene)>& is_wanted)
    : camera_count_(camera_count) {
  for (std::int64_t scene = 0; scene < instant_count * camera_count; ++scene) {
    wanted_.push_back(is_wanted(scene));
    if (wanted_.back()) ++scene_count_;
  }
}

bool WorkPlan::hasInstant(std::int64_t instant) const {
  for (std::int64_t scene = instant * camera_count_; scene < (instant + 1) * camera_count_;
       ++scene) {
    if (hasScene(scene)) return true;
  }
  return false;
}

std::int64_t WorkPlan::endOfWork(std::int64_t end) const {
  while (end > 0 && !hasInstant(end - 1)) --end;
  return end;
}

}  // namespace synthetic_dataset::run
