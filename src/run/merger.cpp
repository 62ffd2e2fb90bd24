#include "run/merger.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "output/earlier_dataset.h"
#include "output/files/file_name_rules.h"
#include "output/manifest/manifest_content.h"
#include "run/label_counts.h"
#include "run/open_output.h"
#include "run/setup/run_record.h"
#include "run/setup/run_setup.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::run {
namespace {

namespace fs = std::filesystem;

struct FoundShard {
  std::string manifest;
  output::ShardPlace place;
  output::ManifestContent content;
};

std::string folderName(const std::string& folder) {
  const std::string path = output::absolutePath(folder);
  return path.size() > 1 && path.back() == '/' ? path.substr(0, path.size() - 1) : path;
}

std::vector<FoundShard> findShards(const std::set<std::string>& folders) {
  std::vector<FoundShard> shards;
  for (const std::string& folder : folders) {
    if (!fs::is_directory(folder)) throw Error("'" + folder + "': no such folder");
    for (const std::string& manifest : output::shardManifests(folder)) {
      const auto shard = output::shardOfManifest(fs::path(manifest).filename().string());
      shards.push_back({manifest, {folder, *shard}, output::readManifest(manifest)});
    }
  }
  std::sort(shards.begin(), shards.end(), [](const FoundShard& a, const FoundShard& b) {
    return a.place.shard.index < b.place.shard.index;
  });
  return shards;
}

std::string named(const FoundShard& shard) {
  return "shard " + output::shardText(shard.place.shard) + " in '" + shard.place.folder + "'";
}

/// Whether the writers of two shards write to the same places relative to their shards' folders.
bool writeAlike(const FoundShard& one, const FoundShard& other) {
  const auto& a = one.content.writers;
  const auto& b = other.content.writers;
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const auto& x, const auto& y) {
    return movedFolder(x.output_folder, one.place.folder, "") ==
           movedFolder(y.output_folder, other.place.folder, "");
  });
}

/// Files that a shard lists outside its own and its writers' folders.
std::vector<std::string> foreignFiles(const FoundShard& shard) {
  return output::filesOutsideRun(shard.content, shard.place.folder, shard.content.writers);
}

/// The reasons why shards do not form one run.
std::vector<std::string> problemsOf(const std::vector<FoundShard>& shards) {
  std::vector<std::string> problems;
  const FoundShard& first = shards.front();
  std::map<std::int64_t, const FoundShard*> by_index;
  for (const FoundShard& each : shards) {
    if (each.place.shard.count != first.place.shard.count) {
      problems.push_back(named(each) + " and " + named(first) + " have different shard counts");
      continue;
    }
    const auto [other, is_new] = by_index.emplace(each.place.shard.index, &each);
    if (!is_new) problems.push_back(named(each) + " is there twice: " + named(*other->second));
    if (!each.content.complete) {
      problems.push_back(named(each) + " is not complete: it has " +
                         std::to_string(each.content.scene_count) +
                         " scenes so far; run it again to continue it");
    }
    if (!each.content.is_current) {
      problems.push_back(named(each) + " has a manifest of another format version; merge it with " +
                         "the software that made it");
    }
    if (const auto foreign = foreignFiles(each); !foreign.empty()) {
      problems.push_back(named(each) + " lists files outside of it (" +
                         output::firstNames(foreign) + "); a shard's files lie in its own folders");
    }
    if (!writeAlike(first, each)) {
      problems.push_back(named(first) + " and " + named(each) +
                         " have writers with different output_folders");
    }
    for (const std::string& difference :
         output::differences(first.content.run, each.content.run, named(first), named(each))) {
      problems.push_back("the shards have different settings: " + difference);
    }
  }
  for (std::int64_t index = 0; index < first.place.shard.count; ++index) {
    if (by_index.count(index) != 0) continue;
    problems.push_back("shard " + output::shardText({index, first.place.shard.count}) +
                       " is missing");
  }
  return problems;
}

/// Checks that the inputs have not changed, since the files that describe the whole dataset are
/// made from them.
/// @param now  receives what is only known when scenes are drawn
void requireSameRun(const FoundShard& shard, output::RunDescription& now) {
  const auto& software = shard.content.run.software;
  const auto opengl = software.find("opengl");
  if (opengl != software.end()) now.software.insert(*opengl);
  std::vector<std::string> problems = output::differences(shard.content.run, now, "then", "now");
  if (problems.empty()) return;
  for (std::string& problem : problems) {
    problem = "the shards were made differently than they would be now: " + problem;
  }
  throw ErrorList(problems);
}

/// Removes the shards' manifests once the dataset is complete.
void removeShardManifests(const std::vector<FoundShard>& shards, const std::string& folder) {
  for (const FoundShard& each : shards) {
    if (each.place.folder == folder) ::unlink(each.manifest.c_str());
  }
}

}  // namespace

RunSummary mergeShards(const std::string& output_folder,
                       const std::vector<std::string>& shard_folders, Reporter& reporter,
                       const std::vector<std::string>& plugin_xml_files) {
  const std::string folder = folderName(output_folder);
  std::set<std::string> folders;
  for (const std::string& each : shard_folders) folders.insert(folderName(each));
  if (fs::is_directory(folder) || folders.empty()) folders.insert(folder);
  const std::vector<FoundShard> shards = findShards(folders);
  if (shards.empty()) {
    if (fs::exists(output::manifestFile(folder)) &&
        output::readManifest(output::manifestFile(folder)).complete) {
      RunSummary summary;
      summary.was_complete = true;
      return summary;
    }
    throw Error("'" + *folders.begin() + "': no shards are there (each leaves a " +
                "manifest.shard-INDEX-of-COUNT.sqlite in its output_folder)");
  }
  const std::vector<std::string> problems = problemsOf(shards);
  if (!problems.empty()) throw ErrorList(problems);

  RunSetup setup =
      setUpRun(recordedSettings(shards.front().content, shards.front().place.folder, folder),
               plugin_xml_files, [&](const std::string& stage) { reporter.stage(stage); });
  requireSameRun(shards.front(), setup.description);
  const auto store = openMerged(setup);
  RunSummary summary;
  summary.was_complete = store->wasComplete();
  summary.manifest = store->manifestPath();
  if (!summary.was_complete) {
    for (const FoundShard& each : shards) store->mergeShard(each.place);
    const std::int64_t found = store->counts().scenes;
    if (found != setup.description.scene_count) {
      throw Error("the shards have " + std::to_string(found) + " scenes in total; the run has " +
                  std::to_string(setup.description.scene_count));
    }
    setup.writers->finalize(*store);
    complete(*store, setup.config.objects);
    reporter.info(std::to_string(found) + " scenes of " + std::to_string(shards.size()) +
                  " shards merged");
    summary.missing_labels = missingLabels(*store, setup.config.objects);
    for (const std::string& message : summary.missing_labels) reporter.warning(message);
  }
  removeShardManifests(shards, folder);
  reporter.info("manifest: " + summary.manifest);
  return summary;
}

}  // namespace synthetic_dataset::run
