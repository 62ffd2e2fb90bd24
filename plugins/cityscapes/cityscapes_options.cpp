#include "plugins/cityscapes/cityscapes_options.h"

#include <algorithm>

#include <opencv2/core/matx.hpp>

#include "plugins/shared/colour_map.h"

namespace synthetic_dataset {
namespace {

/// The greatest label whose instances' numbers all fit into 16 bits.
constexpr int kGreatestLabel = 64;

/// Whether a number is that of a label that Cityscapes uses in training and evaluation.
bool isEvaluated(int id) {
  const CityscapesEntry* entry = entryOf(cityscapesOwnTable(), id);
  return entry != nullptr && entry->train_id != kCityscapesIgnored;
}

/// The table of the dataset's own labels; train ids follow the order of entries.
CityscapesTable tableOf(const CityscapesOptions& options) {
  CityscapesTable table = {{"unlabeled", 0}};
  const auto add = [&](const std::string& name, int id, int train_id, bool has_instances) {
    const cv::Vec3b colour = vocColourMap().at(static_cast<std::size_t>(id));
    table.push_back({name,
                     id,
                     train_id,
                     has_instances ? "object" : "world",
                     has_instances ? 2 : 1,
                     has_instances,
                     false,
                     {{colour[2], colour[1], colour[0]}}});
  };
  int train_id = 0;
  if (options.world_id != 0) add("world", options.world_id, train_id++, false);
  const auto addAll = [&](const std::vector<CityscapesLabel>& labels, bool has_instances) {
    for (const CityscapesLabel& label : labels) {
      const CityscapesEntry* known = entryOf(table, label.id);  // classes may share a label
      add(label.name, label.id, known != nullptr ? known->train_id : train_id++, has_instances);
    }
  };
  addAll(options.labels, true);
  addAll(options.world, false);
  return table;
}

/// @param is_own  whether labels are Cityscapes' own; then each has to be one of them
void readWorldLabels(Parameters& ids, const std::vector<std::string>& names, bool is_own,
                     CityscapesOptions& options) {
  int next = 1;
  for (const CityscapesLabel& label : options.labels) next = std::max(next, label.id + 1);
  for (const std::string& name : names) {
    const auto given = ids.maybe<int>(name);
    const int id = given.value_or(next++);
    const bool fits = is_own ? given && entryOf(cityscapesOwnTable(), id) != nullptr
                             : id >= 1 && id <= kGreatestLabel;
    const std::string right =
        is_own ? "one of Cityscapes' own, 0 to 33" : "1 to " + std::to_string(kGreatestLabel);
    if (!fits && given) {
      ids.addError(name, "found " + std::to_string(id) + "; it should be " + right);
    } else if (!fits) {
      ids.addError(name, "missing; this part of the world should have a label too, " + right);
    }
    options.world.push_back({name, fits ? id : 0, -1});
  }
}

}  // namespace

CityscapesOptions readCityscapesOptions(Parameters& parameters,
                                        const std::vector<ClassInfo>& classes,
                                        const std::vector<std::string>& world_classes) {
  CityscapesOptions options;
  options.world_id = parameters.optional("world_id", options.world_id);
  if (options.world_id < 0 || options.world_id > kGreatestLabel) {
    parameters.addError("world_id", "found " + std::to_string(options.world_id) +
                                        "; it should be 0 to " + std::to_string(kGreatestLabel));
  }
  Parameters ids = parameters.group("label_ids");
  bool all_are_own = options.world_id == 0 || isEvaluated(options.world_id);
  for (const ClassInfo& each : classes) {
    // 0 is reserved for unlabeled.
    const auto given = ids.maybe<int>(each.name);
    all_are_own = all_are_own && given && isEvaluated(*given);
    const int id = given.value_or(each.id + 1);
    if (id < 1 || id > kGreatestLabel) {
      parameters.addError("label_ids", "found " + std::to_string(id) + " for the class '" +
                                           each.name + "'; it should be 1 to " +
                                           std::to_string(kGreatestLabel) +
                                           ": instances are numbered from 1000 times that, "
                                           "in 16 bits");
    }
    if (id == options.world_id && id <= kGreatestLabel) {
      parameters.addError("world_id", "found " + std::to_string(id) +
                                          ", which is also the label of the class '" + each.name +
                                          "'; it should be another");
    }
    // The error ends the run; until then, any label will do.
    options.labels.push_back({each.name, id < 1 || id > kGreatestLabel ? 1 : id, each.id});
  }
  if (options.world_id < 0 || options.world_id > kGreatestLabel) options.world_id = 0;
  all_are_own = all_are_own && !classes.empty();
  readWorldLabels(ids, world_classes, all_are_own, options);
  options.table = all_are_own ? cityscapesOwnTable() : tableOf(options);
  if (all_are_own) {
    for (CityscapesLabel& label : options.labels) {
      label.name = entryOf(options.table, label.id)->name;
    }
    for (CityscapesLabel& label : options.world) {
      label.name = entryOf(options.table, label.id)->name;
    }
  }
  return options;
}

}  // namespace synthetic_dataset
