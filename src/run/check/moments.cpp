#include "run/check/moments.h"

#include <algorithm>

namespace synthetic_dataset::run {
namespace {

constexpr std::size_t kMostMoments = 100;

Moment recordedMoment(const MotionSetup& motion, Stamp stamp) {
  Moment moment{stamp, {}};
  for (const scene::ObjectOptions& object : motion.config.objects) {
    const bool is_there = object.takes_part && !object.is_distractor;
    const auto frame = is_there ? motion.frames->find(object.frame) : std::nullopt;
    moment.X_GO.push_back(frame ? motion.frames->pose(*frame, stamp) : std::nullopt);
  }
  return moment;
}

Moment placedMoment(const MotionSetup& motion, const Scene& scene) {
  Moment moment{scene.stamp, {}};
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const scene::ObjectOptions& object = motion.config.objects[i];
    const bool is_there = object.takes_part && !object.is_distractor;
    moment.X_GO.push_back(is_there ? scene.objects[i].X_GO : std::nullopt);
  }
  return moment;
}

}  // namespace

std::vector<std::size_t> evenlySpread(std::size_t count, std::size_t most) {
  std::vector<std::size_t> indices;
  const std::size_t taken = std::min(count, most);
  for (std::size_t i = 0; i < taken; ++i) {
    indices.push_back(taken == 1 ? 0 : i * (count - 1) / (taken - 1));
  }
  return indices;
}

std::vector<Moment> momentsOf(const MotionSetup& motion, const std::vector<const Scene*>& scenes) {
  std::vector<Moment> moments;
  if (motion.timeline.is_recorded) {
    for (const std::size_t i : evenlySpread(motion.timeline.stamps.size(), kMostMoments)) {
      moments.push_back(recordedMoment(motion, motion.timeline.stamps[i]));
    }
    return moments;
  }
  for (const Scene* scene : scenes) moments.push_back(placedMoment(motion, *scene));
  return moments;
}

}  // namespace synthetic_dataset::run
