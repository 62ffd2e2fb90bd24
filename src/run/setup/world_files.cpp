#include "run/setup/world_files.h"

#include <cstdint>
#include <optional>

#include "base/json_text.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {
WorldFiles::WorldFiles(const config::WorldConfig& config)
    : world_file_(config.file),
      finder_(config.model_folders, packages_.finder(), packages_.exports()),
      loader_(finder_, config.loading) {}

const world::Description& WorldFiles::world() {
  if (!world_) world_ = loader_.loadWorld(world_file_);
  return *world_;
}

const world::Model& WorldFiles::model(const std::string& model_or_uri, const std::string& name) {
  const auto key = std::make_pair(model_or_uri, name);
  const auto found = models_.find(key);
  if (found != models_.end()) return found->second;
  return models_.emplace(key, loader_.loadModel(model_or_uri, name)).first->second;
}

WorldFiles& WorldCache::filesFor(const config::WorldConfig& config) {
  Value::List key{config.file, config.loading.on_missing_asset == world::OnMissingAsset::kWarn};
  const std::optional<world::Simulator>& simulator = config.loading.simulator;
  key.emplace_back(simulator ? static_cast<std::int64_t>(*simulator) : -1);
  for (const std::string& folder : config.model_folders) key.emplace_back(folder);
  std::unique_ptr<WorldFiles>& files = files_[base::jsonText(Value(key))];
  if (!files) files = std::make_unique<WorldFiles>(config);
  return *files;
}

}  // namespace synthetic_dataset::run
