#include "run/setup/world_files.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

#include "base/input_file.h"

#include "base/json_text.h"
#include "run/setup/model_folder_hint.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/value.h"
#include "world/files/findings.h"
#include "world/files/template_file.h"

namespace synthetic_dataset::run {
namespace {

/// Loads a world or a model; if files are missing, the error says where they may be and how to do
/// without them.
/// @param finder  searches for the files
template <class Load>
auto explainingMissing(const std::string& world_file, const world::ResourceFinder& finder,
                       const Load& load) -> decltype(load()) {
  try {
    return load();
  } catch (const world::MissingAssets& missing) {
    std::vector<std::string> messages = missing.messages();
    const std::string hint = modelFolderHint(world_file, finder.unresolved());
    if (!hint.empty()) messages.push_back(hint);
    const bool one = missing.count() == 1;
    messages.push_back((one ? "1 file is" : std::to_string(missing.count()) + " files are") +
                       " missing or cannot be read; 'world/on_missing_asset: warn' draws the rest");
    throw ErrorList(std::move(messages));
  }
}

/// Whether an opened file belongs to the world, unlike those read while searching for ROS packages.
bool isOfWorld(const std::filesystem::path& file) {
  std::error_code ignored;
  return file.filename() != "package.xml" && std::filesystem::is_regular_file(file, ignored);
}

}  // namespace

WorldFiles::WorldFiles(const config::WorldConfig& config, const base::OnStage& on_stage)
    : world_file_(config.file),
      finder_(config.model_folders, packages_.finder(), packages_.exports()),
      loader_(finder_, config.loading, on_stage) {}

template <class Load>
auto WorldFiles::read(const Key& key, const Load& load) -> decltype(load()) {
  const base::InputWatch watch;
  const bool was_uncacheable = std::exchange(is_uncacheable_, true);  // in case it throws
  auto content = explainingMissing(world_file_, finder_, load);
  is_uncacheable_ = was_uncacheable;
  read_.push_back(key);
  keepFiles(watch.files());
  return content;
}

/// Keeps the stamps of all files that were found, not found, or included by others.
void WorldFiles::keepFiles(const std::set<std::filesystem::path>& opened) {
  namespace fs = std::filesystem;
  for (const fs::path& file : finder_.missed()) stamps_.add(file);
  for (const fs::path& file : finder_.found()) {
    stamps_.add(file);
    if (world::isTemplate(file)) is_uncacheable_ = true;  // it includes others
  }
  for (const fs::path& file : opened) {
    stamps_.add(file);
    if (finder_.found().count(file) == 0 && isOfWorld(file)) included_.insert(file);
  }
}

void WorldFiles::noteAsked(const Key& key) {
  if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.push_back(key);
}

const world::Description& WorldFiles::world() {
  const Key key;
  if (!world_) world_ = read(key, [&] { return loader_.loadWorld(world_file_); });
  noteAsked(key);
  return *world_;
}

const world::Model& WorldFiles::model(const std::string& model_or_uri, const std::string& name,
                                      const world::TemplateArguments& arguments) {
  const auto key = std::make_tuple(model_or_uri, name, arguments);
  auto found = models_.find(key);
  if (found == models_.end()) {
    world::Model model =
        read(key, [&] { return loader_.loadModel(model_or_uri, name, arguments); });
    found = models_.emplace(key, std::move(model)).first;
  }
  noteAsked(key);
  return found->second;
}

WorldFiles& WorldCache::filesFor(const config::WorldConfig& config) {
  Value::List key{config.file, config.loading.on_missing_asset == world::OnMissingAsset::kWarn};
  const std::optional<world::Simulator>& simulator = config.loading.simulator;
  key.emplace_back(simulator ? static_cast<std::int64_t>(*simulator) : -1);
  for (const std::string& folder : config.model_folders) key.emplace_back(folder);
  Kept& kept = worlds_[base::jsonText(Value(key))];
  if (!kept.files) {
    kept.files = std::make_unique<WorldFiles>(config, on_stage_);
    ++read_count_;
  }
  kept.unused = 0;
  return *kept.files;
}

void WorldCache::beginUse() {
  constexpr int kLongest = 20;  // so that a user can switch back and forth between two worlds
  for (auto each = worlds_.begin(); each != worlds_.end();) {
    const bool is_kept = each->second.files->areCurrent() && each->second.unused < kLongest;
    if (is_kept) {
      each->second.files->beginUse();
      ++each->second.unused;
    }
    each = is_kept ? std::next(each) : worlds_.erase(each);
  }
}

bool WorldCache::areCurrent() const {
  return std::all_of(worlds_.begin(), worlds_.end(), [](const auto& entry) {
    return entry.second.unused > 0 || entry.second.files->areCurrent();
  });
}

bool WorldCache::isAsFresh() const {
  return std::all_of(worlds_.begin(), worlds_.end(), [](const auto& entry) {
    return entry.second.unused > 0 || entry.second.files->areAsFresh();
  });
}

}  // namespace synthetic_dataset::run
