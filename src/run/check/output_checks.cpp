#include "run/check/output_checks.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace synthetic_dataset::run {

std::optional<output::EarlierRun> earlierRunOf(const RunSetup& setup) {
  const output::StoreOptions& options = setup.config.output;
  // Without an output_folder, each writer has its own.
  if (options.folder.empty() || options.if_exists == output::IfExists::kOverwrite) {
    return std::nullopt;
  }
  return output::findEarlierRun(options, setup.writers->storeWriters(), setup.description);
}

std::optional<Finding> checkEarlierRun(const RunSetup& setup,
                                       const std::optional<output::EarlierRun>& earlier) {
  if (!earlier) return std::nullopt;
  const output::StoreOptions& options = setup.config.output;
  if (earlier->is_written) {
    return Finding{kEarlierDataset, "output_folder",
                   "another run is writing the dataset in '" + options.folder + "'",
                   "wait for its end, or choose another folder"};
  }
  if (!earlier->fault.empty()) {
    return Finding{kEarlierDataset, "output_folder", earlier->fault, ""};
  }
  const std::int64_t scenes = earlier->scene_count;
  const std::string dataset = std::string(earlier->complete ? "a complete" : "an unfinished") +
                              " dataset of " + std::to_string(scenes) +
                              (scenes == 1 ? " scene" : " scenes");
  Finding finding{kEarlierDataset, "output_folder", "",
                  "choose another folder, or set `if_exists: overwrite` to replace that dataset"};
  if (options.if_exists == output::IfExists::kError) {
    finding.found = "'" + options.folder + "' holds " + dataset + ", and `if_exists: error`";
    return finding;
  }
  const std::vector<std::string>& differences = earlier->differences;
  if (differences.empty()) return std::nullopt;
  finding.found =
      "'" + options.folder + "' holds " + dataset + " of other settings (" + differences.front();
  const std::size_t more = differences.size() - 1;
  if (more > 0) finding.found += ", and " + std::to_string(more) + " more";
  finding.found += ")";
  return finding;
}

std::vector<Finding> checkFilesInTheWay(const RunSetup& setup) {
  std::vector<Finding> findings;
  for (const std::string& each :
       output::filesInTheWay(setup.config.output, setup.writers->storeWriters())) {
    findings.push_back({"files in the way", "output_folder", each, ""});
  }
  return findings;
}

}  // namespace synthetic_dataset::run
