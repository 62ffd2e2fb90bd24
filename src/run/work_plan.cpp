#include "run/work_plan.h"

namespace synthetic_dataset {

WorkPlan::WorkPlan(std::int64_t instant_count, std::int64_t camera_count,
                   const std::optional<output::Shard>& shard, const std::set<std::int64_t>& only,
                   const std::function<bool(std::int64_t scene)>& is_there)
    : wanted_(static_cast<std::size_t>(instant_count), false),
      there_(static_cast<std::size_t>(instant_count * camera_count), false) {
  for (std::int64_t instant = 0; instant < instant_count; ++instant) {
    if (shard && !belongsTo(*shard, instant, instant_count)) continue;
    if (!only.empty() && only.count(instant) == 0) continue;
    scene_count_ += camera_count;
    for (std::int64_t camera = 0; camera < camera_count; ++camera) {
      const std::int64_t scene = instant * camera_count + camera;
      there_[static_cast<std::size_t>(scene)] = is_there(scene);
      if (!lacks(scene)) continue;
      ++missing_count_;
      wanted_[static_cast<std::size_t>(instant)] = true;
    }
  }
}

std::int64_t WorkPlan::endOfWork(std::int64_t end) const {
  while (end > 0 && !wants(end - 1)) --end;
  return end;
}

}  // namespace synthetic_dataset
