#include "run/setup/expected_labels.h"

#include <algorithm>
#include <cstddef>

#include "scene/camera_poses.h"

namespace synthetic_dataset::run {
namespace {

/// Whether the centre of a box or one of its corners is in the image.
bool isInView(const CameraModel& camera, const Cuboid& box_O, const Pose& X_CO) {
  std::vector<Eigen::Vector3d> points_O{box_O.centre()};
  for (const Eigen::Vector3d& corner : box_O.corners()) points_O.push_back(corner);
  return std::any_of(points_O.begin(), points_O.end(), [&](const Eigen::Vector3d& p_O) {
    const Eigen::Vector3d p_C = X_CO * p_O;
    if (p_C.norm() < camera.near() || p_C.norm() > camera.far()) return false;
    const auto pixel = camera.project(p_C);
    return pixel && pixel->x() >= -0.5 && pixel->y() >= -0.5 &&
           pixel->x() <= camera.width() - 0.5 && pixel->y() <= camera.height() - 0.5;
  });
}

struct KnownObject {
  std::size_t class_index;
  motion::FrameId frame;
  Cuboid box_O;
};

std::vector<KnownObject> knownObjects(const MotionSetup& motion) {
  std::vector<KnownObject> known;
  for (std::size_t i = 0; i < motion.config.objects.size(); ++i) {
    const scene::ObjectOptions& object = motion.config.objects[i];
    const auto frame = motion.frames->find(object.frame);
    if (!object.takes_part || object.is_distractor || !frame) continue;
    const auto own =
        std::find_if(motion.config.classes.begin(), motion.config.classes.end(),
                     [&](const config::ClassConfig& each) { return each.id == object.class_id; });
    if (own == motion.config.classes.end()) continue;
    known.push_back({static_cast<std::size_t>(own - motion.config.classes.begin()), *frame,
                     motion.shapes->boxesAtRest(i).front()});
  }
  return known;
}

}  // namespace

std::vector<ClassCounts> expectedLabels(const MotionSetup& motion) {
  if (!motion.timeline.is_recorded || !motion.frames || !motion.shapes || !motion.world) return {};
  const std::vector<KnownObject> objects = knownObjects(motion);
  std::vector<ClassCounts> all;
  for (const Stamp stamp : motion.timeline.stamps) {
    ClassCounts& counts = all.emplace_back(motion.config.classes.size(), 0);
    for (const scene::CameraRig& camera : motion.cameras) {
      if (camera.sampled) continue;
      const Pose X_CG =
          scene::cameraPose(camera, *motion.world, *motion.frames, stamp).X_GC.inverse();
      for (const KnownObject& object : objects) {
        const auto X_GO = motion.frames->pose(object.frame, stamp);
        if (X_GO && isInView(camera.model, object.box_O, X_CG * *X_GO)) {
          ++counts[object.class_index];
        }
      }
    }
  }
  return all;
}

}  // namespace synthetic_dataset::run
