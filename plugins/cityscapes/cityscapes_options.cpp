#include "plugins/cityscapes/cityscapes_options.h"

namespace synthetic_dataset {
namespace {

/// The greatest label for which all of its instances' numbers have 16 bits.
constexpr int kGreatestLabel = 64;

}  // namespace

CityscapesOptions readCityscapesOptions(Parameters& parameters,
                                        const std::vector<ClassInfo>& classes) {
  CityscapesOptions options;
  options.world_id = parameters.optional("world_id", options.world_id);
  if (options.world_id < 0 || options.world_id > kGreatestLabel) {
    parameters.addError("world_id", "found " + std::to_string(options.world_id) +
                                        "; it should be 0 to " + std::to_string(kGreatestLabel));
  }
  Parameters ids = parameters.group("label_ids");
  for (const ClassInfo& each : classes) {
    // 0 is what has no label.
    const int id = ids.maybe<int>(each.name).value_or(each.id + 1);
    if (id < 1 || id > kGreatestLabel) {
      parameters.addError("label_ids", "found " + std::to_string(id) + " for the class '" +
                                           each.name + "'; it should be 1 to " +
                                           std::to_string(kGreatestLabel) +
                                           ": instances are numbered from 1000 times that on, "
                                           "in 16 bits");
    }
    if (id == options.world_id && id <= kGreatestLabel) {
      parameters.addError("world_id", "found " + std::to_string(id) +
                                          ", which is also the label of the class '" + each.name +
                                          "'; it should be another");
    }
    options.labels.push_back({each.name, id, each.id});
  }
  return options;
}

}  // namespace synthetic_dataset
