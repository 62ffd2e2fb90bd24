#include "run/open_output.h"

#include "output/earlier_dataset.h"

namespace synthetic_dataset {

std::optional<output::Shard> shardOf(const config::OutputConfig& config) {
  if (!config.shard) return std::nullopt;
  return output::Shard{config.shard->index, config.shard->count};
}

namespace {

output::IfExists ifExists(config::IfExists choice) {
  switch (choice) {
    case config::IfExists::kOverwrite:
      return output::IfExists::kOverwrite;
    case config::IfExists::kError:
      return output::IfExists::kError;
    default:
      return output::IfExists::kResume;
  }
}

output::Sync syncOf(config::Sync choice) {
  switch (choice) {
    case config::Sync::kOff:
      return output::Sync::kOff;
    case config::Sync::kScene:
      return output::Sync::kScene;
    default:
      return output::Sync::kBatch;
  }
}

std::unique_ptr<output::DatasetStore> open(const RunSetup& setup, output::Source source) {
  const config::OutputConfig& config = setup.config.output;
  output::StoreOptions options;
  options.folder = config.folder;
  options.if_exists = ifExists(config.if_exists);
  options.sync = syncOf(config.sync);
  options.shard = shardOf(config);
  options.source = source;
  options.png_compression = config.png_compression;
  options.jpeg_quality = config.jpeg_quality;
  return std::make_unique<output::DatasetStore>(options, setup.writers->storeWriters(),
                                                setup.description);
}

}  // namespace

std::unique_ptr<output::DatasetStore> openOutput(const RunSetup& setup) {
  return open(setup, output::Source::kScenes);
}

void clearOutput(const Value& parameters, const std::vector<std::string>& plugin_xml_files) {
  const RunSetup setup = setUpRun(parameters, plugin_xml_files);
  openOutput(setup).reset();
  output::EarlierDataset(setup.config.output.folder, std::nullopt).remove();
}

std::unique_ptr<output::DatasetStore> openMerged(const RunSetup& setup) {
  return open(setup, output::Source::kShards);
}

}  // namespace synthetic_dataset
