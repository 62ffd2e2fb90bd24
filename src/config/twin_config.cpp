#include "config/readers.h"

#include <cstdint>
#include <optional>
#include <string>

#include "base/seconds.h"
#include "config/checked_values.h"

namespace synthetic_dataset::config {
namespace {

/// Checks that all cameras have recorded pictures, as a scene has a single time.
void checkCameras(Parameters& root, const scene::SceneOptions& scenes,
                  scene::RecordedImageOutput output) {
  for (const scene::CameraOptions& camera : scenes.cameras) {
    if (!camera.image_topic) {
      root.addError(camera.group,
                    "has no image_topic, and another camera has; all cameras of a motion should "
                    "have recorded pictures, or none");
      continue;
    }
    const bool is_only_one = camera.group == "camera";
    Parameters group =
        is_only_one ? root.group("camera") : root.group("cameras").group(camera.name);
    if (output == scene::RecordedImageOutput::kReal && group.has("effects")) {
      group.addError("effects",
                     "found together with image_topic; a recorded picture has the effects of its "
                     "own camera (with twin/output: both or synthetic, drawn ones have these)");
    }
  }
}

/// Refuses randomization of what a recorded picture or cloud shows as it was.
void checkRandomization(Parameters& root, const scene::SceneOptions& scenes) {
  const randomize::Randomization& randomization = scenes.randomization;
  const std::string reason =
      std::string("found together with ") +
      (scenes.isTwin() ? "image_topic; recorded pictures" : "cloud_topic; recorded clouds") +
      " show what was there. In a list of motions, give it only to the others";
  Parameters group = root.group("randomize");
  if (!randomization.objects.empty()) group.addError("objects", reason);
  if (randomization.distractors) group.addError("distractors", reason);
  if (randomization.time_jitter) group.addError("time", reason);
  if (scenes.isTwin() && randomization.sensor.field_of_view) {
    group.group("sensor").addError("field_of_view", reason);
  }
}

/// Checks runs in which only clouds are recorded.
void checkTimingLidar(Parameters& root, const scene::SceneOptions& scenes) {
  if (scenes.timingLidar() == nullptr) return;
  if (scenes.isPlaced()) {
    root.addError(
        "motion",
        "found placement, and a lidar with a cloud_topic; recorded clouds are labelled by "
        "the recording's TF (motion: bag)");
  }
  checkRandomization(root, scenes);
}

/// Reads `output`; `both` should have been split into two runs, with `real` and `synthetic`.
scene::RecordedImageOutput readOutput(Parameters& group) {
  const auto both = std::optional<scene::RecordedImageOutput>();
  const auto output = choice<std::optional<scene::RecordedImageOutput>>(
      group, "output",
      {{"real", scene::RecordedImageOutput::kReal},
       {"synthetic", scene::RecordedImageOutput::kSynthetic},
       {"both", both}});
  if (output == both) {
    group.addError("output",
                   "found both, which makes two datasets of a whole run; beside `motions`, or in "
                   "the settings of one of them, it should be real or synthetic");
  }
  return output.value_or(scene::RecordedImageOutput::kReal);
}

/// Reads the topics that measure surfaces in front of objects, and their tolerances.
void readMeasured(Parameters& group, scene::RecordedImageOptions& twin) {
  constexpr double kWidest = 10.0;       // [m]
  constexpr double kSteepest = 1.0;      // share of the distance
  constexpr double kLongestTime = 10.0;  // [s]
  twin.depth_topic = group.maybe<std::string>("depth_topic");
  twin.depth_info_topic = group.maybe<std::string>("depth_info_topic");
  twin.cloud_topic = group.maybe<std::string>("cloud_topic");
  if (twin.depth_info_topic && !twin.depth_topic) {
    group.addError("depth_info_topic", "found without depth_topic, whose calibration it names");
  }
  twin.depth_is_rectified = twin.depth_topic && isRectifiedTopic(*twin.depth_topic);
  if (!twin.isMeasured()) {
    for (const char* const name : {"depth_margin", "depth_margin_growth", "depth_time"}) {
      if (!group.has(name)) continue;
      group.ignore(name);
      group.addError(name, "found without depth_topic or cloud_topic, to which it applies");
    }
    return;
  }
  label::OcclusionMargin& margin = twin.margin;
  margin.least = group.optionalBetween("depth_margin", margin.least, 0.0, kWidest);
  margin.growth = group.optionalBetween("depth_margin_growth", margin.growth, 0.0, kSteepest);
  twin.depth_time = base::fromSeconds(
      group.optionalBetween("depth_time", toSeconds(twin.depth_time), 0.0, kLongestTime));
}

scene::RecordedImageOptions readGroup(Parameters group) {
  constexpr std::int64_t kMost = 1000000;
  constexpr double kLongest = 1.0;  // [s]
  scene::RecordedImageOptions twin;
  twin.output = readOutput(group);
  if (group.has("every")) twin.every = group.optionalBetween<std::int64_t>("every", 1, 1, kMost);
  if (group.has("min_alignment")) {
    twin.min_alignment = group.optionalBetween("min_alignment", 0.0, 0.0, 1.0);
  }
  readMeasured(group, twin);
  if (group.has("same_time")) {
    twin.same_time = base::fromSeconds(
        group.optionalBetween("same_time", toSeconds(twin.same_time), 0.0, kLongest));
  }
  return twin;
}

}  // namespace

scene::RecordedImageOptions readTwinOptions(Parameters root, const scene::SceneOptions& scenes) {
  const scene::RecordedImageOptions twin = readGroup(root.group("twin"));
  if (!scenes.isTwin()) {
    if (root.has("twin")) {
      root.addError("twin", "found without a camera's image_topic, to whose pictures it applies");
    }
    checkTimingLidar(root, scenes);
    return twin;
  }
  if (scenes.isPlaced()) {
    root.addError("motion",
                  "found placement, and a camera with an image_topic; recorded pictures are "
                  "labelled by the recording's TF (motion: bag)");
  }
  checkCameras(root, scenes, twin.output);
  checkRandomization(root, scenes);
  return twin;
}

}  // namespace synthetic_dataset::config
