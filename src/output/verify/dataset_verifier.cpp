#include "output/verify/dataset_verifier.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "output/file_checks.h"
#include "output/files/file_name_rules.h"
#include "output/files/run_lock.h"
#include "output/manifest/manifest_checks.h"
#include "output/verify/scene_verifier.h"
#include "output/written_dataset.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

namespace fs = std::filesystem;

/// The manifests in a folder: of a whole run, and of shards.
std::vector<std::string> manifestsIn(const std::string& folder) {
  std::vector<std::string> manifests;
  std::error_code error;
  const std::string whole = output::manifestFile(folder);
  if (fs::exists(fs::symlink_status(whole, error))) manifests.push_back(whole);
  for (std::string& shard : output::shardManifests(folder)) manifests.push_back(std::move(shard));
  return manifests;
}

std::string stateProblem(const output::ManifestContent& content) {
  if (content.complete) return "";
  return "its state is 'running': " + std::to_string(content.scene_count) +
         " scenes are there, of " + std::to_string(content.run.scene_count) + " that the " +
         (content.shard ? "run has in all its shards" : "run has") +
         "; the same command that began it continues it";
}

/// Verifies one folder with all its manifests.
class Verification {
 public:
  Verification(const std::string& folder, VerificationDepth depth, WriterLoader* loader,
               VerificationListener& listener, const DrawAgain& draw_again)
      : folder_(folder),
        depth_(depth),
        loader_(loader),
        listener_(listener),
        draw_again_(draw_again) {}

  VerificationCounts run() {
    const std::vector<std::string> manifests = manifestsIn(folder_);
    if (manifests.empty()) {
      listener_.problem("'" + folder_ + "': no dataset is there (a run leaves its " +
                        "manifest.sqlite in its output_folder)");
    }
    for (const std::string& manifest : manifests) {
      if (!output::RunLock::isHeld(manifest)) continue;
      listener_.problem("'" + manifest + "': a run is writing it right now; verify the dataset " +
                        "when that has ended");
      return counts_;
    }
    for (const std::string& manifest : manifests) guarded(manifest, [&] { open(manifest); });
    for (const auto& dataset : datasets_) {
      guarded(dataset->manifest(), [&] { verifyScenes(*dataset); });
    }
    // If a manifest cannot be read, its files would seem to belong to nobody.
    if (datasets_.size() == manifests.size()) findStrayFiles();
    checkShards();
    return counts_;
  }

 private:
  /// Runs work that may find the manifest unreadable.
  template <class Work>
  void guarded(const std::string& manifest, const Work& work) {
    try {
      work();
    } catch (const std::exception& error) {
      listener_.problem("'" + manifest + "': " + error.what());
    }
  }

  void open(const std::string& manifest) {
    const std::vector<std::string> damage = output::structureProblems(manifest);
    for (const std::string& problem : damage) listener_.problem("'" + manifest + "': " + problem);
    if (!damage.empty()) return;
    auto dataset =
        std::make_unique<WrittenDataset>(manifest, base::SqliteDatabase::Mode::kReadOnly);
    const output::ManifestContent& content = dataset->content();
    const std::string state = stateProblem(content);
    if (!state.empty()) listener_.problem("'" + manifest + "': " + state);
    for (const std::string& problem : output::contentProblems(manifest, content)) {
      listener_.problem("'" + manifest + "': " + problem);
    }
    datasets_.push_back(std::move(dataset));
  }

  void verifyScenes(const WrittenDataset& dataset) {
    SceneVerifier verifier(dataset, depth_, loader_, listener_, counts_);
    verifier.verifyDatasetFiles();
    const std::int64_t count = dataset.content().scene_count;
    std::int64_t done = 0;
    dataset.forEachScene([&](const output::SceneFacts& scene) {
      verifier.verifyScene(scene);
      listener_.progress(++done, count);
    });
    verifier.verifyDatasetValues();
    if (draw_again_) drawAgain(dataset, verifier);
  }

  void drawAgain(const WrittenDataset& dataset, SceneVerifier& verifier) {
    const auto report = [&](const std::string& what) {
      listener_.problem("'" + dataset.manifest() + "' cannot be drawn again: " + what);
    };
    try {
      draw_again_(dataset, verifier);
    } catch (const ErrorList& errors) {
      for (const std::string& each : errors.messages()) report(each);
    } catch (const std::exception& error) {
      report(error.what());
    }
  }

  void findStrayFiles() {
    std::vector<const WrittenDataset*> datasets;
    std::set<std::string> folders;
    bool is_running = false;
    for (const auto& dataset : datasets_) {
      datasets.push_back(dataset.get());
      is_running = is_running || !dataset->content().complete;
      for (const output::StoreWriter& writer : dataset->content().writers) {
        folders.insert(writer.output_folder);
      }
    }
    for (const std::string& folder : folders) {
      const output::StrayFiles stray = output::strayFiles(folder, datasets);
      tellStray(folder, stray.unlisted, "files that no manifest lists");
      if (is_running && stray.half_written.count > 0) {
        listener_.remark("'" + folder + "': " + std::to_string(stray.half_written.count) +
                         " files are half written; resuming the run replaces them");
      } else {
        tellStray(folder, stray.half_written, "half-written files of a run that was cut short");
      }
    }
  }

  void tellStray(const std::string& folder, const output::FewFiles& files,
                 const std::string& what) {
    if (files.count == 0) return;
    std::string named;
    for (const std::string& file : files.named) named += (named.empty() ? "'" : ", '") + file + "'";
    if (files.count > static_cast<std::int64_t>(files.named.size())) named += " and more";
    listener_.problem("'" + folder + "': found " + std::to_string(files.count) + " " + what + " (" +
                      named + "); it should have none");
  }

  /// Checks that all shards in the folder belong to one run.
  void checkShards() {
    const WrittenDataset* first = nullptr;
    std::int64_t count = 0;
    for (const auto& dataset : datasets_) {
      if (!dataset->content().shard) continue;
      ++count;
      if (first == nullptr) first = dataset.get();
      const output::ManifestContent& content = dataset->content();
      if (content.shard->count != first->content().shard->count ||
          settingsDigest(content.run) != settingsDigest(first->content().run)) {
        listener_.problem("'" + dataset->manifest() + "': it is not a shard of the run of '" +
                          first->manifest() + "': the settings, or the number of shards, differ");
      }
    }
    if (first == nullptr) return;
    const std::int64_t of = first->content().shard->count;
    if (count < of) {
      listener_.remark("'" + folder_ + "': " + std::to_string(count) + " of " + std::to_string(of) +
                       " shards are here");
    }
  }

  std::string folder_;
  VerificationDepth depth_;
  WriterLoader* loader_;
  VerificationListener& listener_;
  const DrawAgain& draw_again_;
  std::vector<std::unique_ptr<WrittenDataset>> datasets_;
  VerificationCounts counts_;
};

VerificationCounts verified(const std::string& folder, VerificationDepth depth,
                            WriterLoader* loader, VerificationListener& listener,
                            const DrawAgain& draw_again) {
  std::string absolute = output::absolutePath(folder);
  if (absolute.size() > 1 && absolute.back() == '/') absolute.pop_back();
  return Verification(absolute, depth, loader, listener, draw_again).run();
}

}  // namespace

VerificationCounts verifyDataset(const std::string& folder, VerificationDepth depth,
                                 VerificationListener& listener, const DrawAgain& draw_again) {
  if (depth == VerificationDepth::kSizes) {
    return verified(folder, depth, nullptr, listener, draw_again);
  }
  std::unique_ptr<WriterLoader> writers;
  try {
    writers = std::make_unique<WriterLoader>(std::vector<std::string>());
  } catch (const std::exception& error) {
    listener.remark(std::string("labels are not checked: ") + error.what());
  }
  return verified(folder, depth, writers.get(), listener, draw_again);
}

VerificationCounts verifyDataset(const std::string& folder, VerificationDepth depth,
                                 VerificationListener& listener, WriterLoader& writers,
                                 const DrawAgain& draw_again) {
  return verified(folder, depth, &writers, listener, draw_again);
}

}  // namespace synthetic_dataset::output
