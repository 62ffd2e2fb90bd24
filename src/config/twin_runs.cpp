#include "config/twin_runs.h"

#include <string>
#include <utility>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::config {
namespace {

/// The entry as a group; nullptr if it is not one.
Value::Map* groupOf(Value::Map& settings, const std::string& name) {
  const auto entry = settings.find(name);
  return entry == settings.end() ? nullptr : entry->second.as<Value::Map>();
}

bool makesBoth(const Value::Map& settings) {
  const auto twin = settings.find("twin");
  const auto* group = twin == settings.end() ? nullptr : twin->second.as<Value::Map>();
  if (group == nullptr || settings.count("motions") != 0) return false;
  const auto output = group->find("output");
  return output != group->end() && output->second == Value("both");
}

void removeEffects(Value::Map& settings) {
  if (Value::Map* camera = groupOf(settings, "camera")) camera->erase("effects");
  Value::Map* cameras = groupOf(settings, "cameras");
  if (cameras == nullptr) return;
  for (auto& [name, camera] : *cameras) {
    if (camera.is<Value::Map>()) camera.as<Value::Map>()->erase("effects");
  }
}

/// The folder that contains both datasets.
std::string commonFolderOf(const Value::Map& settings) {
  std::vector<std::string> errors;
  const auto folder = settings.find("output_folder");
  const auto* text = folder == settings.end() ? nullptr : folder->second.as<std::string>();
  if (text == nullptr || text->empty()) {
    errors.emplace_back(
        "output_folder: missing; with twin/output: both it should name the folder in which `real` "
        "and `synthetic` are made");
  }
  for (const auto& [name, value] : settings) {
    const auto* group = value.as<Value::Map>();
    if (group == nullptr || group->count("output_folder") == 0) continue;
    errors.push_back(name +
                     "/output_folder: found together with twin/output: both, which makes two "
                     "datasets; their writers' folders should be those below output_folder");
  }
  if (!errors.empty()) throw ErrorList(errors);
  return *text;
}

}  // namespace

std::vector<Value> twinRuns(const Value& settings) {
  const auto* all = settings.as<Value::Map>();
  if (all == nullptr || !makesBoth(*all)) return {settings};
  const std::string folder = commonFolderOf(*all);
  std::vector<Value> runs;
  for (const std::string output : {"real", "synthetic"}) {
    Value::Map run = *all;
    (*groupOf(run, "twin"))["output"] = Value(output);
    run["output_folder"] = Value(folder + (folder.back() == '/' ? "" : "/") + output);
    if (output == "real") removeEffects(run);
    runs.emplace_back(std::move(run));
  }
  return runs;
}

}  // namespace synthetic_dataset::config
