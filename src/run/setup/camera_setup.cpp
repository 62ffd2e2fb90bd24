#include "run/setup/camera_setup.h"

#include <algorithm>
#include <string>
#include <utility>

#include "run/setup/setup_notes.h"
#include "scene/stereo_pairs.h"

namespace synthetic_dataset::run {
namespace {

/// The centres of the boxes around an object's variants, in its frame.
std::vector<Eigen::Vector3d> middlesOf(const MotionSetup& setup, std::size_t object) {
  std::vector<Eigen::Vector3d> middles;
  if (!setup.shapes) return middles;  // the error is already noted
  for (const Cuboid& box_O : setup.shapes->boxesAtRest(object)) {
    middles.push_back(box_O.centre());
  }
  return middles;
}

/// Whether a placed camera's frame belongs to something else, which would then move with it.
bool isTaken(const std::string& frame, const scene::CameraOptions& camera, MotionSetup& setup) {
  std::string owner = frame == setup.config.global_frame ? "global_frame" : "";
  for (const scene::ObjectOptions& object : setup.config.objects) {
    if (object.frame == frame) owner = object.name;
  }
  for (const scene::CameraRig& other : setup.cameras) {
    if (other.frame == frame) owner = "the camera " + other.name;
  }
  if (owner.empty()) return false;
  setup.diagnostics.error(camera.group + "/frame_id",
                          "found '" + frame + "', which is also the frame of " + owner +
                              "; a camera that is placed needs a frame of its own");
  return true;
}

/// Whether a camera's pose or direction is undefined while an object's pose is unknown.
bool needs(const MotionSetup& setup, std::size_t camera, std::size_t object) {
  const scene::CameraRig& rig = setup.cameras[camera];
  const auto name = setup.config.objects[object].name;
  if (rig.looks_at && rig.looks_at->object == object) return true;
  if (rig.is_carried && rig.followed == setup.frames->find(setup.config.objects[object].frame)) {
    return true;
  }
  if (rig.link) {
    return setup.world->links()[*rig.link].object == static_cast<int>(object);
  }
  return std::any_of(setup.config.cameras.begin(), setup.config.cameras.end(),
                     [&](const scene::CameraOptions& each) {
                       return each.name == rig.name && each.sample && each.sample->look_at == name;
                     });
}

}  // namespace

void setUpCameras(MotionSetup& setup,
                  const std::optional<std::vector<world::CameraSensor>>& sensors) {
  static const std::vector<world::LinkInstance> kNoLinks;
  static const std::vector<world::CameraSensor> kNoSensors;
  for (const scene::CameraOptions& camera : setup.config.cameras) {
    const bool two_sources = camera.info_file && camera.info_topic;
    const bool no_source = !camera.info_file && !camera.info_topic && !camera.sensor;
    if (two_sources || no_source) continue;  // reported already
    if (!setup.frames || (!sensors && camera.sensor)) {
      // What else it lacks has been reported; its calibration may be wrong, too.
      (void)setup.diagnostics.attempt([&] { scene::checkInfoFile(camera); });
      continue;
    }
    auto rig = setup.diagnostics.attempt([&] {
      return scene::makeCameraRig(camera, setup.config.motion.bag_files,
                                  sensors ? *sensors : kNoSensors,
                                  setup.world ? setup.world->links() : kNoLinks,
                                  setup.config.objects, *setup.frames, setup.diagnostics);
    });
    if (!rig) continue;
    if (rig->sampled && isTaken(rig->frame, camera, setup)) continue;
    if (rig->sampled) rig->followed = setup.frames->place(rig->frame, Pose::Identity());
    if (rig->looks_at) rig->looks_at->centres_O = middlesOf(setup, rig->looks_at->object);
    noteStrangeLens(camera, rig->model, setup.diagnostics);
    setup.cameras.push_back(std::move(*rig));
  }
  if (setup.frames) scene::placeStereoPairs(setup.cameras, *setup.frames, setup.diagnostics);
  scene::notePictureFrames(setup.cameras, setup.diagnostics);
}

void requireObjectsOfCameras(MotionSetup& setup) {
  for (std::size_t i = 0; i < setup.config.objects.size(); ++i) {
    scene::ObjectOptions& object = setup.config.objects[i];
    if (object.when_unknown == scene::WhenUnknown::kSkipScene) continue;
    for (std::size_t camera = 0; camera < setup.cameras.size(); ++camera) {
      if (!needs(setup, camera, i)) continue;
      object.when_unknown = scene::WhenUnknown::kSkipScene;
      setup.diagnostics.note(
          object.name + "/when_unknown",
          "scenes in which its pose is unknown are still left out, as the camera " +
              setup.cameras[camera].name + " is on it or looks at it");
      break;
    }
  }
}

}  // namespace synthetic_dataset::run
