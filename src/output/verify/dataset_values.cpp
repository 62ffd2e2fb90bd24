/// Verifies the content of the files of the dataset as a whole.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "output/manifest/manifest_paths.h"
#include "output/verify/dataset_comparison.h"
#include "output/verify/expected_files.h"
#include "output/verify/label_checks.h"
#include "output/verify/scene_verifier.h"
#include "plugins/readback/files.h"

namespace synthetic_dataset::output {
namespace {

/// The records that a writer stored for all scenes.
class ListedRecords : public SceneRecords {
 public:
  ListedRecords(const WrittenDataset& dataset, std::size_t writer)
      : dataset_(dataset), writer_(writer) {}

  void forEach(const std::string& channel,
               const std::function<void(std::int64_t scene_index, const std::string& record)>&
                   visit) const override {
    dataset_.forEachRecord(writer_, channel, visit);
  }

 private:
  const WrittenDataset& dataset_;
  std::size_t writer_;
};

}  // namespace

void SceneVerifier::verifyDatasetValues() {
  const ManifestContent& content = dataset_.content();
  if (depth_ != VerificationDepth::kLabels || !content.complete || content.shard) return;
  std::vector<std::vector<std::string>> paths(content.writers.size());
  dataset_.forEachFileOf(std::nullopt, [&](const ListedFile& file) {
    if (file.writer < paths.size() && pathProblem(file, dataset_).empty()) {
      paths[file.writer].push_back(absoluteFrom(dataset_.folder(), file.path));
    }
  });
  for (std::size_t i = 0; i < paths.size(); ++i) {
    // Errors in a scene carry over to these files, and have been reported already.
    if (labels_[i].writer == nullptr || !labels_[i].is_right) continue;
    try {
      compareDatasetFiles(i, paths[i]);
    } catch (const std::exception& error) {
      listener_.problem("writer '" + content.writers[i].name + "': " + error.what());
    }
  }
}

void SceneVerifier::compareDatasetFiles(std::size_t writer, const std::vector<std::string>& paths) {
  const ReadyWriter& ready = *labels_[writer].writer;
  const StoreWriter& of = dataset_.content().writers[writer];
  const std::string origin = "writer '" + of.name + "': ";
  const ListedRecords records(dataset_, writer);
  const DifferingFiles differing =
      differingDatasetFiles(ready, records, {paths.begin(), paths.end()});
  for (const std::string& problem : differing.problems) listener_.problem(origin + problem);
  for (const std::string& file : differing.not_compared) {
    remark("'" + pathBelow(of.output_folder, file) + "' of '" + of.name +
           "' is checked only by its size and SHA-256: it is too large to be made again");
  }
  if (differing.files.empty()) return;
  ExpectedFiles right(ready);
  right.addDataset(records);
  formats::Differences differences;
  for (const std::string& file : differing.files) {
    if (differing.by_name.count(file) > 0) continue;
    compareDatasetFile(file, right.placeOf(file).string(), pathBelow(of.output_folder, file),
                       differences);
  }
  if (differences.empty() && differing.by_name.empty()) return;
  if (reportWrongLabels(writer, right)) return;
  for (const std::string& line : differences.lines()) listener_.problem(origin + line);
  for (const std::string& file : differing.by_name) {
    remark("'" + pathBelow(of.output_folder, file) + "' of '" + of.name +
           "' has other bytes than its writer makes, but the same labels");
  }
}

/// Finds the scenes whose labels are wrong in the files of the dataset as a whole.
bool SceneVerifier::reportWrongLabels(std::size_t writer, ExpectedFiles& right) {
  constexpr int kMost = 10;  // scenes
  const Labels& labels = labels_[writer];
  if (!labels.can_be_read || !labels.format->needs_dataset_files) return false;
  const auto kept = std::make_shared<formats::KeptFiles>();
  int count = 0;
  dataset_.forEachScene([&](const SceneFacts& facts) {
    if (count >= kMost) return;
    WrittenFiles files;
    dataset_.forEachFileOf(facts.index, [&](const ListedFile& file) {
      if (file.writer == writer) files.paths.push_back(absoluteFrom(dataset_.folder(), file.path));
    });
    if (files.paths.empty()) return;
    const formats::WrittenScene found = writtenScene(facts, writer, files);
    formats::WrittenScene of_right = found;
    of_right.folder = right.folder();
    of_right.kept = kept;
    for (std::filesystem::path& path : of_right.files) {
      right.addRight(path.string());
      path = right.placeOf(path.string());
    }
    const std::vector<std::string> problems = labelProblems(
        labels.format->read(found), labels.format->read(of_right), facts, dataset_.content().run);
    count += problems.empty() ? 0 : 1;
    for (const std::string& each : problems) report(writer, originOf(facts, writer) + each);
  });
  return count > 0;
}

}  // namespace synthetic_dataset::output
