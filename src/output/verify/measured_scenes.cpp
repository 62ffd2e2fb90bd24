#include "output/verify/measured_scenes.h"

#include <algorithm>

#include "base/yaml_value.h"
#include "output/writer_settings.h"

namespace synthetic_dataset::output {
namespace {

bool startsWith(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

std::string textOf(const std::map<std::string, Value>& settings, const std::string& name) {
  const auto found = settings.find(name);
  return found == settings.end() ? "" : found->second.text();
}

bool hasExactMasks(const std::map<std::string, Value>& settings) {
  if (const std::string method = textOf(settings, "masks/method"); !method.empty()) {
    return method == "exact";
  }
  const std::string subtractor = "background_subtractor";
  const auto next = settings.lower_bound(subtractor);
  return next == settings.end() || !startsWith(next->first, subtractor);
}

}  // namespace

MeasuredScenes::MeasuredScenes(const output::RunDescription& run) {
  for (const auto& [name, setting] : run.settings) {
    settings_[name] = base::parseYaml(setting.value, "setting '" + name + "'");
  }
  has_exact_masks_ = hasExactMasks(settings_);
  std::map<int, std::string> class_names;
  for (const auto& each : run.classes) {
    classes_.push_back({each.id, each.name});
    class_names[each.id] = each.name;
  }
  for (const auto& each : run.objects) {
    formats::MeasuredObject object;
    object.name = each.name;
    object.id = each.id;
    object.class_id = each.class_id;
    object.class_name = class_names[each.class_id];
    object.class_text = textOf(settings_, each.name + "/class");
    if (object.class_text.empty()) object.class_text = object.class_name;
    objects_.push_back(std::move(object));
  }
}

Value::Map MeasuredScenes::settingsOf(const output::StoreWriter& writer) const {
  return writerSettings(settings_, writer.name);
}

Parameters MeasuredScenes::parametersOf(const output::StoreWriter& writer) const {
  return Parameters(settingsOf(writer), writer.name);
}

formats::MeasuredScene MeasuredScenes::scene(const output::SceneFacts& facts,
                                             const output::StoreWriter& writer) const {
  formats::MeasuredScene scene;
  scene.size = {facts.width, facts.height};
  scene.has_exact_masks = has_exact_masks_;
  const Pose X_CG = facts.X_GC.inverse();
  for (std::size_t i = 0; i < std::min(facts.objects.size(), objects_.size()); ++i) {
    const output::ObjectFacts& of_object = facts.objects[i];
    formats::MeasuredObject object = objects_[i];
    if (of_object.X_GO) object.X_CO = X_CG * *of_object.X_GO;
    object.in_view = of_object.in_view;
    object.dropped = of_object.dropped;
    object.loose_box = of_object.loose_box;
    object.silhouette_box = of_object.silhouette_box;
    object.visible_box = of_object.visible_box;
    object.silhouette_pixels = of_object.silhouette_pixels;
    object.visible_pixels = of_object.visible_pixels;
    object.truncation = of_object.truncation;
    object.is_subtracted = of_object.mask_agreement.has_value();
    const std::string warning = "writer '" + writer.name + "': " + object.name + ": ";
    object.is_warned_of =
        std::any_of(facts.warnings.begin(), facts.warnings.end(),
                    [&](const output::Warning& each) { return startsWith(each.kind, warning); });
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

}  // namespace synthetic_dataset::output
