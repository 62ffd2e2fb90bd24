#include "programs/setup_assistant/service/run_service.h"

#include <system_error>
#include <utility>
#include <vector>

#include "base/json_text.h"
#include "config/checked_values.h"
#include "output/files/run_lock.h"
#include "output/manifest/manifest_schema.h"
#include "output/written_dataset.h"
#include "programs/setup_assistant/run/child_program.h"
#include "programs/setup_assistant/service/request_body.h"
#include "programs/setup_assistant/web/http_message.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

namespace fs = std::filesystem;

std::string settingText(const Value& group, const std::string& name) {
  const auto* map = group.as<Value::Map>();
  const auto found = map == nullptr ? Value::Map::const_iterator() : map->find(name);
  if (map == nullptr || found == map->end()) return "";
  const auto* text = found->second.as<std::string>();
  return text == nullptr ? "" : *text;
}

/// The setting that makes a run produce only some of its scenes.
std::string onlyScenes(const Value& wanted) {
  Value::List scenes;
  constexpr std::int64_t kMost = 10000;
  if (const auto* count = wanted.as<std::int64_t>(); count != nullptr && *count <= kMost) {
    for (std::int64_t i = 0; i < *count; ++i) scenes.emplace_back(i);
  } else if (const auto* list = wanted.as<Value::List>()) {
    scenes = *list;
  }
  if (scenes.empty())
    throw HttpError(400, "scenes: it should be a number of scenes, 1 to 10000, or a list");
  return "only_scenes:=" + base::jsonText(scenes);
}

/// Adds how far somebody else's run is, according to what it has written.
void countScenes(const std::string& folder, Value::Map& state) {
  try {
    state["scenes_done"] = output::WrittenDataset(folder).counts().scenes;
  } catch (const Error&) {  // the run has only just begun
  }
}

bool isHeldNow(const std::string& folder) {
  return !folder.empty() && output::RunLock::isHeld(output::manifestFile(folder));
}

}  // namespace

std::string outputFolderOf(const Value& settings) {
  return config::absolutePath(settingText(settings, "output_folder"));
}

RunService::RunService(DocumentService& document, const AllowedFolders& allowed,
                       std::function<void(const Value& state)> on_change,
                       std::function<void()> on_end)
    : document_(document),
      allowed_(allowed),
      on_change_(std::move(on_change)),
      on_end_(std::move(on_end)),
      run_([this] {
        on_change_(state());
        if (!run_.isRunning()) on_end_();
      }) {}

Value RunService::start(const Value& body) {
  const Value::Map own = settings();
  requireOwnFolders(own);
  if (isHeldNow(outputFolderOf(own))) throw HttpError(409, "a run is already writing this dataset");
  std::vector<std::string> command = {programBesideThis("generate"), "--config", document_.file(),
                                      "--json"};
  const Value scenes = entryOf(body, "scenes");
  if (!scenes.isNull()) command.push_back(onlyScenes(scenes));
  const std::string replaced = textOf(body, "replace");
  if (!replaced.empty() && replaced != outputFolderOf(own)) {
    throw HttpError(409, "the output folder has changed from '" + replaced + "' to '" +
                             outputFolderOf(own) + "'; nothing was removed");
  }
  if (!replaced.empty()) command.emplace_back("if_exists:=overwrite");
  run_.start(command);
  return state();
}

Value RunService::stop() {
  run_.stop();
  return state();
}

Value RunService::state() {
  Value::Map state = run_.state();
  const auto effective = document_.effective();
  const std::string folder = effective.settings ? outputFolderOf(*effective.settings) : "";
  state["output_folder"] = folder;
  const bool is_elsewhere = !run_.isRunning() && isHeldNow(folder);
  state["elsewhere"] = is_elsewhere;
  if (is_elsewhere) state["state"] = "running";
  if (is_elsewhere) countScenes(folder, state);
  return state;
}

void RunService::look() {
  const auto effective = document_.effective();
  const bool is_elsewhere =
      !run_.isRunning() && effective.settings && isHeldNow(outputFolderOf(*effective.settings));
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_elsewhere == was_elsewhere_) return;
    was_elsewhere_ = is_elsewhere;
  }
  on_change_(state());
  on_end_();
}

/// The settings that the run will read from the disk.
Value::Map RunService::settings() {
  document_.requireOnDisk();
  const auto effective = document_.effective();
  if (!effective.settings) throw ErrorList(effective.errors);
  const auto* map = effective.settings->as<Value::Map>();
  return map == nullptr ? Value::Map{} : *map;
}

/// If the page could choose the folder freely, it could have any of the user's files overwritten.
void RunService::requireOwnFolders(const Value::Map& settings) const {
  std::vector<std::pair<std::string, std::string>> targets = {
      {"output_folder", settingText(Value(settings), "output_folder")}};
  for (const auto& [name, group] : settings) {
    const std::string folder = settingText(group, "output_folder");
    targets.emplace_back(name + "/output_folder", folder);
    // A relative path starts at the writer's folder: one of its own, or one below the dataset's.
    const fs::path list = settingText(group, "main_list");
    const fs::path base = folder.empty() ? outputFolderOf(Value(settings)) + "/" + name : folder;
    targets.emplace_back(name + "/main_list",
                         list.empty() || list.is_absolute() ? list : base / list);
  }
  for (const auto& [name, target] : targets) {
    if (target.empty()) continue;
    std::error_code error;
    const fs::path resolved = fs::weakly_canonical(config::absolutePath(target), error);
    if (!error && isBelow(resolved, allowed_.home())) continue;
    throw HttpError(403, name + ": found '" + target + "', but this page writes only below '" +
                             allowed_.home().string() +
                             "'; `\"$(dirname)/dataset\"` would be right, or a run by hand: "
                             "`rosrun synthetic_dataset generate --config " +
                             document_.file() + "`");
  }
}

}  // namespace synthetic_dataset::programs
