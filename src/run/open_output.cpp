#include "run/open_output.h"

#include "output/earlier_dataset.h"

namespace synthetic_dataset::run {

namespace {

std::unique_ptr<output::DatasetStore> open(const RunSetup& setup, output::Source source) {
  output::StoreOptions options = setup.config.output;
  options.source = source;
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

}  // namespace synthetic_dataset::run
