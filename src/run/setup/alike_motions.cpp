#include "run/setup/alike_motions.h"

#include <algorithm>
#include <set>
#include <string>

namespace synthetic_dataset::run {
namespace {

/// Cameras must agree, since scenes are numbered across all cameras.
void checkCameras(const std::vector<MotionSetup>& motions, base::Diagnostics& diagnostics) {
  const auto namesOf = [](const MotionSetup& motion) {
    std::string names;
    for (const scene::CameraOptions& camera : motion.config.cameras) {
      names += (names.empty() ? "'" : ", '") + camera.name + "'";
    }
    return names;
  };
  const MotionSetup& first = motions.front();
  for (const MotionSetup& motion : motions) {
    if (namesOf(motion) == namesOf(first)) continue;
    diagnostics.error(motion.entry.group + "/cameras",
                      "found " + namesOf(motion) + "; " + first.entry.group + " has " +
                          namesOf(first) +
                          ", and all motions should have cameras of the same names");
  }
}

/// Lidars must agree, since all scenes of a dataset have the same clouds.
void checkLidars(const std::vector<MotionSetup>& motions, base::Diagnostics& diagnostics) {
  const auto namesOf = [](const MotionSetup& motion) {
    std::set<std::string> names;
    for (const lidar::LidarOptions& each : motion.config.lidars) {
      names.insert(each.name + " (" + each.frame + ")");
    }
    return names;
  };
  for (const MotionSetup& motion : motions) {
    if (namesOf(motion) == namesOf(motions.front())) continue;
    diagnostics.error(motion.entry.group + "/lidars",
                      "found other lidars or frames than the first motion has; all motions "
                      "should have lidars of the same names and frames");
  }
}

/// Labelled distractors must agree, as they are objects of the dataset that all motions share.
void checkDistractors(const std::vector<MotionSetup>& motions, base::Diagnostics& diagnostics) {
  const auto hasSome = [](const MotionSetup& motion) {
    return motion.config.robotCount() < motion.config.objects.size();
  };
  if (std::none_of(motions.begin(), motions.end(), hasSome)) return;
  for (const MotionSetup& motion : motions) {
    if (!motion.entry.says("randomize/distractors")) continue;
    diagnostics.error(motion.entry.group + "/randomize/distractors",
                      "distractors with a class are objects of the whole "
                      "dataset; their settings should be at the top level, not in a motion");
  }
}

/// Class names must agree, as they belong to the dataset; what they select may differ between
/// worlds.
void checkWorldClasses(const std::vector<MotionSetup>& motions, base::Diagnostics& diagnostics) {
  const auto namesOf = [](const MotionSetup& motion) {
    std::set<std::string> names;
    for (const auto& [name, patterns] : motion.config.world_classes) names.insert(name);
    return names;
  };
  for (const MotionSetup& motion : motions) {
    if (namesOf(motion) == namesOf(motions.front())) continue;
    diagnostics.error(
        motion.entry.group + "/world_classes",
        "found other classes than the first motion has; all should have the same names");
  }
}

}  // namespace

void checkMotionsCompatible(const std::vector<MotionSetup>& motions,
                            base::Diagnostics& diagnostics) {
  checkCameras(motions, diagnostics);
  checkLidars(motions, diagnostics);
  checkDistractors(motions, diagnostics);
  checkWorldClasses(motions, diagnostics);
}

}  // namespace synthetic_dataset::run
