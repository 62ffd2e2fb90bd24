#include "config/readers.h"

#include "config/checked_values.h"
#include "config/distribution_config.h"

namespace synthetic_dataset::config {
namespace {

double readFallTime(Parameters& group, randomize::DistractorMode mode, double fallback) {
  if (mode == randomize::DistractorMode::kDrop) {
    return numberAbove(group, "fall_time", fallback, randomize::kShortestFall);
  }
  refuseWithout(group, {"fall_time"}, "mode: drop");
  return fallback;
}

std::string readTextures(Parameters& group) {
  const auto textures = group.optional<std::string>("textures", "procedural");
  return textures == "none" ? textures : picturesFrom(textures);
}

std::vector<Eigen::Vector3d> readColours(Parameters& group) {
  auto colours =
      group.maybe<std::vector<Eigen::Vector3d>>("colours").value_or(std::vector<Eigen::Vector3d>{});
  for (const Eigen::Vector3d& colour : colours) {
    if (colour.minCoeff() >= 0.0 && colour.maxCoeff() <= 1.0) continue;
    group.addError("colours",
                   "found a number that is not 0 to 1; each colour should be [red, green, "
                   "blue], sRGB-encoded");
    return {};
  }
  return colours;
}

}  // namespace

std::optional<randomize::DistractorOptions> readDistractors(Parameters randomize) {
  if (!randomize.has("distractors")) return std::nullopt;
  Parameters group = randomize.group("distractors");
  constexpr int kMost = 1000;
  constexpr double kSmallest = 1e-3;  // [m]
  constexpr double kLargest = 1e3;    // [m]
  randomize::DistractorOptions distractors;
  distractors.pool = group.optionalBetween("pool", distractors.pool, 1, kMost);
  if (auto count = maybeDistribution(group, "count", {1, 0.0, kMost})) distractors.count = *count;
  distractors.models =
      group.maybe<std::vector<std::string>>("models").value_or(std::vector<std::string>{});
  for (std::string& model : distractors.models) model = pathOrUri(model);
  if (distractors.models.empty()) {
    if (auto size = maybeDistribution(group, "size", {1, kSmallest, kLargest})) {
      distractors.size = *size;
    }
    distractors.textures = readTextures(group);
    distractors.colours = readColours(group);
  }
  distractors.mode =
      listedChoice<randomize::DistractorMode>(group, "mode",
                                              {{"fly", randomize::DistractorMode::kFly},
                                               {"stand", randomize::DistractorMode::kStand},
                                               {"drop", randomize::DistractorMode::kDrop}});
  distractors.fall_time = readFallTime(group, distractors.mode, distractors.fall_time);
  if (group.has("volume")) distractors.volume = readVolume(group);
  if (group.has("class")) distractors.label_class = readLabel(group, "class");
  if (group.has("tries")) {
    distractors.tries = group.optionalBetween("tries", distractors.tries, 1, 1000000);
  }
  return distractors;
}

}  // namespace synthetic_dataset::config
