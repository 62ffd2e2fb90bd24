#include "plugins/nuscenes/nuscenes_options.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {

namespace {

/// Reads `lidar`, which defaults to the only lidar.
void readLidar(Parameters& parameters, const DatasetInfo& dataset, NuScenesOptions& options) {
  if (dataset.lidars.empty()) return;
  const std::string name = dataset.lidars.size() == 1 ? parameters.optional<std::string>(
                                                            "lidar", dataset.lidars.front().name)
                                                      : parameters.required<std::string>("lidar");
  if (name == "none") return;
  options.lidar = dataset.lidarIndex(parameters, "lidar", name);
  options.positions = readCloudPositions(parameters);
  options.min_points = readMinPoints(parameters);
  options.lidarseg = parameters.optional("lidarseg", options.lidarseg);
  constexpr std::size_t kMostCategories = 255;  // in a byte, in addition to noise
  const std::size_t count = dataset.classes.size() + dataset.world_classes.size();
  if (options.lidarseg && count > kMostCategories) {
    parameters.addError("lidarseg", "found " + std::to_string(count) +
                                        " classes, of which a byte can name 255; it should be "
                                        "false");
  }
}

/// The period of samples, in instants.
std::int64_t readKeyframes(Parameters& parameters, const DatasetInfo& dataset) {
  constexpr std::int64_t kMost = 1000;
  const auto every = parameters.optionalBetween<std::int64_t>("keyframe_every", 1, 1, kMost);
  if (every == 1) return every;
  const auto refuse = [&](const std::string& why) {
    parameters.addError("keyframe_every", "found " + std::to_string(every) + "; " + why);
  };
  for (const MotionInfo& motion : dataset.motions) {
    if (motion.rate == 0.0) {
      refuse("it should be 1 where scenes are placed at random: none is between two others");
      return every;
    }
  }
  for (const SplitInfo& split : dataset.splits) {
    const auto cameras = static_cast<std::int64_t>(dataset.cameras.size());
    if (split.scene_count == 0 || split.scene_count / cameras >= every) continue;
    refuse("it should be " + std::to_string(split.scene_count / cameras) +
           " at most, the instants of " + split.name + ", so that this has a key frame");
  }
  return every;
}

/// The index of an instant's motion; 0 if none is listed.
std::size_t motionOf(const std::vector<MotionInfo>& motions, std::int64_t instant) {
  std::size_t motion = 0;
  while (motion + 1 < motions.size() && motions[motion + 1].first_instant <= instant) ++motion;
  return motion;
}

}  // namespace

NuScenesOptions readNuScenesOptions(Parameters& parameters, const DatasetInfo& dataset) {
  NuScenesOptions options;
  options.version = parameters.optional("version", options.version);
  if (options.version.empty() || options.version.front() == '.' ||
      safeFileName(options.version) != options.version) {
    parameters.addError("version", "found '" + options.version +
                                       "'; it should be the name of a folder, as v1.0-trainval");
    options.version = NuScenesOptions().version;
  }
  options.box = readBoxChoice(parameters);
  options.image_format = parameters.optionalChoice("image_format", {"jpg", "png"}, "jpg");
  options.keyframe_every = readKeyframes(parameters, dataset);
  readLidar(parameters, dataset, options);
  return options;
}

std::string nuScenesToken(NuScenesTable table, std::int64_t first, std::int64_t second) {
  std::array<char, 40> digits{};
  std::snprintf(digits.data(), digits.size(), "%04x%014llx%014llx", static_cast<unsigned>(table),
                static_cast<unsigned long long>(first), static_cast<unsigned long long>(second));
  return digits.data();
}

std::string nuScenesChannel(const std::vector<CameraDescription>& cameras, std::size_t camera) {
  if (cameras.size() == 1) return "CAM_FRONT";
  std::string name = safeFileName(cameras.at(camera).name);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  // Names that differ only in case need different channels.
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    std::string other = safeFileName(cameras[i].name);
    std::transform(other.begin(), other.end(), other.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    if (i != camera && other == name) return "CAM_" + safeFileName(cameras[camera].name);
  }
  return "CAM_" + name;
}

std::size_t nuScenesSequence(const DatasetInfo& dataset, const Scene& scene) {
  const std::vector<std::string> splits = dataset.splitFolders();
  const auto split = std::find(splits.begin(), splits.end(), scene.splitFolder());
  if (split == splits.end()) throw Error("the scene is in a split that the dataset does not have");
  const std::vector<MotionInfo>& motions = dataset.motions;
  return static_cast<std::size_t>(split - splits.begin()) *
             std::max<std::size_t>(motions.size(), 1) +
         motionOf(motions, scene.instant);
}

bool isNuScenesKeyframe(const DatasetInfo& dataset, const NuScenesOptions& options,
                        std::int64_t instant) {
  const std::vector<MotionInfo>& motions = dataset.motions;
  const std::int64_t first =
      motions.empty() ? 0 : motions[motionOf(motions, instant)].first_instant;
  return (instant - first) % options.keyframe_every == 0;
}

}  // namespace synthetic_dataset
