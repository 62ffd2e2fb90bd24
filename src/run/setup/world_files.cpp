#include "run/setup/world_files.h"

#include <cstdint>
#include <optional>

#include "base/json_text.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/value.h"
#include "world/files/findings.h"

namespace synthetic_dataset::run {
namespace {

/// Loads a world or a model; where files are missing, says how to do without them.
template <class Load>
auto explainingMissing(const Load& load) -> decltype(load()) {
  try {
    return load();
  } catch (const world::MissingAssets& missing) {
    std::vector<std::string> messages = missing.messages();
    const bool one = missing.count() == 1;
    messages.push_back((one ? "1 file is" : std::to_string(missing.count()) + " files are") +
                       " missing or cannot be read; 'world/on_missing_asset: warn' draws the rest");
    throw ErrorList(std::move(messages));
  }
}

}  // namespace

WorldFiles::WorldFiles(const config::WorldConfig& config, const base::OnStage& on_stage)
    : world_file_(config.file),
      finder_(config.model_folders, packages_.finder(), packages_.exports()),
      loader_(finder_, config.loading, on_stage) {}

const world::Description& WorldFiles::world() {
  if (!world_) world_ = explainingMissing([&] { return loader_.loadWorld(world_file_); });
  return *world_;
}

const world::Model& WorldFiles::model(const std::string& model_or_uri, const std::string& name,
                                      const world::XacroArguments& arguments) {
  const auto key = std::make_tuple(model_or_uri, name, arguments);
  const auto found = models_.find(key);
  if (found != models_.end()) return found->second;
  world::Model model =
      explainingMissing([&] { return loader_.loadModel(model_or_uri, name, arguments); });
  return models_.emplace(key, std::move(model)).first->second;
}

WorldFiles& WorldCache::filesFor(const config::WorldConfig& config) {
  Value::List key{config.file, config.loading.on_missing_asset == world::OnMissingAsset::kWarn};
  const std::optional<world::Simulator>& simulator = config.loading.simulator;
  key.emplace_back(simulator ? static_cast<std::int64_t>(*simulator) : -1);
  for (const std::string& folder : config.model_folders) key.emplace_back(folder);
  std::unique_ptr<WorldFiles>& files = files_[base::jsonText(Value(key))];
  if (!files) files = std::make_unique<WorldFiles>(config, on_stage_);
  return *files;
}

}  // namespace synthetic_dataset::run
