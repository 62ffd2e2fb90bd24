#include "output/earlier_dataset.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "output/files/file_name_rules.h"
#include "output/files/pending_file.h"
#include "output/files/run_lock.h"
#include "output/preflight.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

namespace fs = std::filesystem;

bool isThere(const std::string& path) {
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

/// A manifest together with its lock and the files that SQLite keeps beside it.
std::vector<std::string> filesOfManifest(const std::string& manifest) {
  return {manifest + "-journal",   manifest + "-wal",         manifest + "-shm",
          temporaryPath(manifest), RunLock::fileOf(manifest), manifest};
}

/// Removes empty folders of the dataset's writers, from this one upwards.
void removeEmptyFolders(fs::path folder, const ManifestContent& content) {
  const auto isOfAWriter = [&content](const std::string& name) {
    return std::any_of(
        content.writers.begin(), content.writers.end(),
        [&](const StoreWriter& writer) { return liesWithin(name, writer.output_folder); });
  };
  while (isOfAWriter(folder.string()) && ::rmdir(folder.c_str()) == 0) {
    folder = folder.parent_path();
  }
}

}  // namespace

std::vector<std::string> filesOutsideRun(const ManifestContent& content, const std::string& folder,
                                         const std::vector<StoreWriter>& writers) {
  std::vector<std::string> folders = {folder};
  std::set<std::string> user_files;
  for (const StoreWriter& writer : writers) {
    folders.push_back(writer.output_folder);
    user_files.insert(writer.user_files.begin(), writer.user_files.end());
  }
  std::vector<std::string> files;
  for (const std::string& file : content.files) {
    if (user_files.count(file) == 0) files.push_back(file);
  }
  return filesOutside(files, folders);
}

EarlierDataset::EarlierDataset(const std::string& folder, const std::optional<Shard>& shard)
    : folder_(folder), shard_(shard) {
  const std::string own = manifestFile(folder_, shard_);
  if (isThere(own)) {
    if (RunLock::isHeld(own)) {
      throw Error("another run is writing the dataset of '" + own +
                  "'; wait for its end, or choose another output_folder");
    }
    own_ = readManifest(own);
    replaced_.push_back({own, *own_});
    know(own, *own_);
  }
  if (shard_ && isThere(manifestFile(folder_))) {
    whole_ = readManifest(manifestFile(folder_));
    know(manifestFile(folder_), *whole_);
  }
  for (const std::string& manifest : shardManifests(folder_)) {
    if (manifest == own) continue;
    shards_.push_back(manifest);
    if (shard_) continue;  // not read: another machine may be writing it
    replaced_.push_back({manifest, readManifest(manifest)});
    know(manifest, replaced_.back().content);
  }
}

void EarlierDataset::know(const std::string& manifest, const ManifestContent& content) {
  for (const std::string& file : content.files) {
    known_files_.insert(file);
    known_files_.insert(temporaryPath(file));
  }
  for (std::string& file : filesOfManifest(manifest)) known_files_.insert(std::move(file));
  const std::string report = reportFile(folder_);
  known_files_.insert({report, temporaryPath(report)});
}

std::vector<std::string> EarlierDataset::datasetsInTheWay(IfExists if_exists, Source source) const {
  std::vector<std::string> obstacles;
  const std::string otherwise =
      "choose another folder, or set `if_exists: overwrite` to replace that dataset";
  if (own_ && if_exists == IfExists::kError) {
    obstacles.push_back("'" + manifestFile(folder_, shard_) + "' lists " +
                        (own_->complete ? "a complete" : "an unfinished") + " dataset of " +
                        std::to_string(own_->scene_count) + " scenes; " + otherwise);
  }
  if (whole_) {
    obstacles.push_back("'" + folder_ + "' holds a dataset that is not made in shards; " +
                        "choose another output_folder for the shards, or remove that dataset");
  }
  if (source == Source::kScenes && !shard_ && !shards_.empty() &&
      if_exists != IfExists::kOverwrite) {
    obstacles.push_back("'" + folder_ + "' holds shards of a run (" +
                        fs::path(shards_.front()).filename().string() +
                        (shards_.size() > 1 ? " and others" : "") +
                        "); `rosrun synthetic_dataset merge " + folder_ +
                        "` makes one dataset of them; otherwise " + otherwise);
  }
  for (const std::string& manifest : shard_ ? shards_ : std::vector<std::string>{}) {
    const std::optional<Shard> other = shardOfManifest(fs::path(manifest).filename().string());
    if (other->count == shard_->count) continue;
    obstacles.push_back("'" + manifest +
                        "' is a shard of a run divided differently; shards of one run " +
                        "should have the same shard/count: found " + std::to_string(shard_->count) +
                        " now and " + std::to_string(other->count) + " then");
    break;
  }
  return obstacles;
}

std::vector<std::string> EarlierDataset::obstacles(const std::vector<StoreWriter>& writers,
                                                   IfExists if_exists, Source source) const {
  std::vector<std::string> obstacles = datasetsInTheWay(if_exists, source);
  const std::vector<std::string> foreign = foreignFiles(writers);
  if (if_exists == IfExists::kOverwrite && !foreign.empty()) {
    obstacles.push_back("the dataset in '" + folder_ + "' lists files outside of it that are not " +
                        "this run's (" + firstNames(foreign) +
                        "); remove that dataset by hand, or choose another output_folder");
  }
  for (const StoreWriter& writer : writers) {
    std::vector<std::string> unlisted = unlistedFiles(writer);
    // They may belong to another shard. Shards make their manifest before any file, so list the
    // files first and only then look for manifests.
    if (shard_ && !shardManifests(folder_).empty()) unlisted.clear();
    if (!unlisted.empty()) {
      obstacles.push_back("writer '" + writer.name + "': the folder '" + writer.output_folder +
                          "' holds files that no manifest lists (" + firstNames(unlisted) +
                          "); choose another output_folder, or move them away "
                          "(`if_exists: overwrite` replaces only what a manifest lists)");
    }
    for (const std::string& file : writer.user_files) {
      std::error_code error;
      if (fs::is_directory(file, error)) {
        obstacles.push_back("writer '" + writer.name + "': '" + file +
                            "' is a folder; it should be the path of a file");
      } else if (if_exists != IfExists::kOverwrite && known_files_.count(file) == 0 &&
                 isThere(file)) {
        obstacles.push_back("writer '" + writer.name + "': the file '" + file +
                            "' exists; choose another path, or set `if_exists: overwrite` to "
                            "replace it");
      }
    }
  }
  return obstacles;
}

std::vector<std::string> EarlierDataset::foreignFiles(
    const std::vector<StoreWriter>& writers) const {
  std::vector<std::string> foreign;
  for (const Listed& listed : replaced_) {
    for (std::string& file : filesOutsideRun(listed.content, folder_, writers)) {
      foreign.push_back(std::move(file));
    }
  }
  return foreign;
}

std::vector<std::string> EarlierDataset::unlistedFiles(const StoreWriter& writer) const {
  std::vector<std::string> unlisted;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(writer.output_folder, error), end;
       !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (entry->symlink_status(ignored).type() == fs::file_type::directory) continue;
    const std::string path = entry->path().string();
    if (FolderProbe::isProbe(path)) continue;    // of a run that is just starting
    const auto& user_files = writer.user_files;  // obstacles() looks at these one by one
    if (known_files_.count(path) != 0 ||
        std::find(user_files.begin(), user_files.end(), path) != user_files.end()) {
      continue;
    }
    unlisted.push_back(entry->path().lexically_relative(writer.output_folder).string());
  }
  std::sort(unlisted.begin(), unlisted.end());
  return unlisted;
}

void EarlierDataset::remove() const {
  const std::string own = manifestFile(folder_, shard_);  // locked by the new run already
  std::vector<std::unique_ptr<RunLock>> locks;
  for (const Listed& listed : replaced_) {
    if (listed.manifest != own) locks.push_back(std::make_unique<RunLock>(listed.manifest));
  }
  for (const Listed& listed : replaced_) removeOne(listed);
}

void EarlierDataset::removeOne(const Listed& listed) const {
  std::vector<std::string> failures;
  const auto removeFile = [&failures](const std::string& file) {
    // unlink(2) does not remove folders, whatever a manifest claims.
    if (::unlink(file.c_str()) != 0 && errno != ENOENT && errno != ENOTDIR) {
      failures.push_back("cannot remove '" + file + "': " + std::generic_category().message(errno));
    }
  };
  for (const std::string& file : listed.content.files) {
    removeFile(file);
    removeFile(temporaryPath(file));
    removeEmptyFolders(fs::path(file).parent_path(), listed.content);
  }
  for (const StoreWriter& writer : listed.content.writers) {
    removeEmptyFolders(fs::path(writer.output_folder).parent_path(), listed.content);
  }
  // The manifest stays as long as anything it lists still exists.
  if (!failures.empty()) throw ErrorList(failures);
  for (const std::string& file : filesOfManifest(listed.manifest)) {
    if (file != RunLock::fileOf(listed.manifest)) removeFile(file);
  }
  if (!failures.empty()) throw ErrorList(failures);
}

}  // namespace synthetic_dataset::output
