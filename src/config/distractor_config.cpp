#include "config/distractor_config.h"

#include "config/checked_values.h"
#include "config/distribution_config.h"

namespace synthetic_dataset::config {
namespace {

bool readFly(const Parameters& group) {
  const auto mode = group.optional<std::string>("mode", "fly");
  if (mode != "fly" && mode != "stand") {
    group.addError("mode", "found '" + mode + "'; it should be fly or stand");
  }
  return mode != "stand";
}

std::string readTextures(const Parameters& group) {
  const auto textures = group.optional<std::string>("textures", "procedural");
  return textures == "procedural" || textures == "none" ? textures : absolutePath(textures);
}

}  // namespace

std::optional<DistractorConfig> readDistractors(const Parameters& randomize) {
  if (!randomize.has("distractors")) return std::nullopt;
  const Parameters group = randomize.group("distractors");
  constexpr int kMost = 1000;
  constexpr double kSmallest = 1e-3;  // [m]
  constexpr double kLargest = 1e3;    // [m]
  DistractorConfig distractors;
  distractors.pool = numberBetween(group, "pool", distractors.pool, 1, kMost);
  if (auto count = maybeDistribution(group, "count", {1, 0.0, kMost})) distractors.count = *count;
  distractors.models =
      group.maybe<std::vector<std::string>>("models").value_or(std::vector<std::string>{});
  for (std::string& model : distractors.models) model = pathOrUri(model);
  if (distractors.models.empty()) {
    if (auto size = maybeDistribution(group, "size", {1, kSmallest, kLargest})) {
      distractors.size = *size;
    }
    distractors.textures = readTextures(group);
  }
  distractors.fly = readFly(group);
  distractors.volume = readVolume(group);
  if (group.has("tries")) {
    distractors.tries = numberBetween(group, "tries", distractors.tries, 1, 1000000);
  }
  return distractors;
}

}  // namespace synthetic_dataset::config
