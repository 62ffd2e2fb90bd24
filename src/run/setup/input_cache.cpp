#include "run/setup/input_cache.h"

#include "run/setup/run_record.h"

namespace synthetic_dataset::run {

std::map<std::string, output::RunDescription::Input> InputCache::describe(
    const std::set<std::string>& files) {
  std::map<std::string, Described> described;
  std::map<std::string, output::RunDescription::Input> inputs;
  for (const std::string& file : files) {
    const auto known = described_.find(file);
    if (known != described_.end() && known->second.stamps.areCurrent()) {
      described.insert(*known);
    } else {
      FileStamps stamps;
      const output::RunDescription::Input input = describeInput(file);
      stamps.add(file);
      described.insert_or_assign(file, Described{stamps, input});
    }
    inputs[file] = described.at(file).input;
  }
  described_ = std::move(described);
  return inputs;
}

}  // namespace synthetic_dataset::run
