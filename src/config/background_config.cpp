#include "config/readers.h"

#include <algorithm>
#include <vector>

#include "config/checked_values.h"
#include "config/distribution_config.h"
#include "randomize/appearance/picture_options.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::config {
namespace {

constexpr double kBrightestPicture = 1e6;
constexpr DistributionRange kColourRange{3, 0.0, 1.0};

const std::vector<std::string>& entryNames() {
  static const std::vector<std::string> kNames = {"colour",     "pictures", "present",
                                                  "projection", "yaw",      "brightness"};
  return kNames;
}

/// Whether it is a group with entries of a background, possibly misspelt; else it is a
/// distribution.
bool isGroup(const std::optional<Value>& background) {
  const auto* map = background ? background->as<Value::Map>() : nullptr;
  if (map == nullptr) return false;
  return std::any_of(map->begin(), map->end(), [](const auto& entry) {
    return nearestName(entry.first, entryNames()).has_value();
  });
}

randomize::BackgroundPictures readPictures(Parameters& group) {
  randomize::BackgroundPictures pictures;
  const auto from = group.required<std::string>("pictures");
  pictures.folder = from == randomize::kNatural ? from : absolutePath(from);
  pictures.present = group.maybeBetween("present", 0.0, 1.0);
  pictures.projection = listedChoice<randomize::BackgroundProjection>(
      group, "projection",
      {{"backdrop", randomize::BackgroundProjection::kBackdrop},
       {"panorama", randomize::BackgroundProjection::kPanorama}});
  if (pictures.projection == randomize::BackgroundProjection::kPanorama) {
    if (from == randomize::kNatural) {
      group.addError("projection",
                     "found panorama beside `pictures: natural`; these are ordinary pictures "
                     "from a camera, not panoramas, so it should be backdrop");
    }
    pictures.yaw = maybeDistribution(group, "yaw", kTurnRange);
  } else {
    refuseWithout(group, {"yaw"}, "projection: panorama");
  }
  pictures.brightness = maybeDistribution(group, "brightness", {1, 0.0, kBrightestPicture});
  return pictures;
}

}  // namespace

randomize::BackgroundRandomization readBackground(Parameters randomize) {
  const std::string name = "background";
  randomize::BackgroundRandomization background;
  if (!randomize.has(name)) return background;
  if (!isGroup(randomize.maybe<Value>(name))) {
    background.colour = maybeDistribution(randomize, name, kColourRange);
    return background;
  }
  Parameters group = randomize.group(name);
  background.colour_name = name + "/colour";
  background.colour = maybeDistribution(group, "colour", kColourRange);
  if (!group.has("pictures")) return background;
  background.pictures = readPictures(group);
  const bool is_always_there = background.pictures->present.value_or(1.0) >= 1.0;
  if (background.colour && is_always_there) {
    group.addError("colour",
                   "found a colour behind pictures that cover it; it should be left out, or "
                   "`present` be given, the probability of a picture");
  }
  return background;
}

}  // namespace synthetic_dataset::config
