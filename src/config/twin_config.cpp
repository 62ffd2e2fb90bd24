#include "config/twin_config.h"

#include <string>
#include <utility>
#include <vector>

#include "base/seconds.h"

namespace synthetic_dataset::config {
namespace {

/// All cameras have pictures, or none: a scene is of one time.
void checkCameras(Parameters& root, const scene::SceneOptions& scenes) {
  for (const scene::CameraOptions& camera : scenes.cameras) {
    if (!camera.image_topic) {
      root.addError(camera.group,
                    "has no image_topic, and another camera has; all cameras of a motion should "
                    "have recorded pictures, or none");
    }
    const bool is_named_in_group = camera.group == "camera";
    Parameters group =
        is_named_in_group ? root.group("camera") : root.group("cameras").group(camera.name);
    if (camera.image_topic && group.has("effects")) {
      group.addError("effects",
                     "found together with image_topic; a recorded picture has the effects of its "
                     "own camera");
    }
  }
}

/// What is in the picture is what was there.
void checkRandomization(Parameters& root, const randomize::Randomization& randomization) {
  const std::string reason =
      "found together with image_topic; recorded pictures show what was there. Where the other "
      "motions of a list need it, it should stand in them";
  Parameters group = root.group("randomize");
  if (!randomization.objects.empty()) group.addError("objects", reason);
  if (randomization.distractors) group.addError("distractors", reason);
  if (randomization.time_jitter) group.addError("time", reason);
  if (randomization.sensor.field_of_view) group.group("sensor").addError("field_of_view", reason);
}

}  // namespace

scene::TwinOptions readTwinOptions(Parameters root, const scene::SceneOptions& scenes) {
  scene::TwinOptions twin;
  if (!scenes.isTwin()) {
    if (!root.has("twin")) return twin;
    root.ignore("twin");
    root.addError("twin", "found without a camera's image_topic, of whose pictures it speaks");
    return twin;
  }
  if (scenes.isPlaced()) {
    root.addError("motion",
                  "found placement, and a camera with an image_topic; recorded pictures are "
                  "labelled by the recording's TF (motion: bag)");
  }
  checkCameras(root, scenes);
  checkRandomization(root, scenes.randomization);
  Parameters group = root.group("twin");
  constexpr std::int64_t kMost = 1000000;
  if (group.has("every")) twin.every = group.optionalBetween<std::int64_t>("every", 1, 1, kMost);
  constexpr double kLongest = 1.0;  // [s]
  if (group.has("same_time")) {
    twin.same_time = base::fromSeconds(
        group.optionalBetween("same_time", toSeconds(twin.same_time), 0.0, kLongest));
  }
  return twin;
}

}  // namespace synthetic_dataset::config
