#include "output/dataset_opening.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include "output/earlier_dataset.h"
#include "output/files/digest.h"
#include "output/files/file_name_rules.h"
#include "output/files/pending_file.h"
#include "output/files/run_lock.h"
#include "output/manifest/manifest.h"
#include "output/manifest/manifest_schema.h"
#include "output/preflight.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

void removeFile(const std::string& path) {
  if (::unlink(path.c_str()) != 0 && errno != ENOENT && errno != ENOTDIR) {
    throw Error("cannot remove '" + path + "': " + std::generic_category().message(errno));
  }
}

void removeFiles(const std::vector<ManifestFile>& files) {
  for (const ManifestFile& file : files) {
    removeFile(file.path);
    removeFile(temporaryPath(file.path));
  }
}

bool isAsWritten(const ManifestFile& file) {
  try {
    const FileDigest found = digestOfFile(file.path);
    return found.bytes == file.bytes && found.digest == file.digest;
  } catch (const Error&) {
    return false;  // the file is missing
  }
}

/// Does not read the file: once safely on disk, a file changes only if somebody changes it.
bool hasItsSize(const ManifestFile& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file.path, error);
  return !error && static_cast<std::int64_t>(size) == file.bytes;
}

bool isWhole(SceneState state, const std::vector<ManifestFile>& files) {
  if (state == SceneState::kBegun) return false;
  return std::all_of(files.begin(), files.end(),
                     state == SceneState::kComplete ? hasItsSize : isAsWritten);
}

/// Drops what a killed run or a power cut left half done, including the files: scenes that were
/// only begun, scenes that were not yet synced and whose files differ from what was written, scenes
/// whose files somebody has since removed or truncated, and the files of the dataset as a whole.
/// @throws Error when a file cannot be removed
void dropUnfinished(Manifest& manifest) {
  for (const auto& [scene, state] : manifest.sceneStates()) {
    const std::vector<ManifestFile> files = manifest.filesOfScene(scene);
    if (isWhole(state, files)) continue;
    removeFiles(files);
    manifest.withdrawScene(scene);
  }
  for (const ManifestFile& file : manifest.filesOfScene(std::nullopt)) {
    removeFiles({file});
    manifest.withdraw(file.path);
  }
}

std::string withoutTrailingSlash(std::string folder) {
  if (folder.size() > 1 && folder.back() == '/') folder.pop_back();
  return folder;
}

void append(std::vector<std::string>& all, const std::vector<std::string>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void makeFolders(const std::string& folder, const std::vector<StoreWriter>& writers,
                 FolderProbe& probe) {
  probe.tryFolder("the dataset's manifest", folder);
  for (const StoreWriter& writer : writers) {
    const std::string owner = "writer '" + writer.name + "'";
    probe.tryFolder(owner, writer.output_folder);
    for (const std::string& file : writer.user_files) {
      probe.tryFolder(owner, std::filesystem::path(file).parent_path().string());
    }
  }
}

/// Why an existing dataset cannot be resumed.
std::vector<std::string> reasonsNotToResume(const ManifestContent& earlier,
                                            const std::vector<StoreWriter>& writers,
                                            const RunDescription& run) {
  std::vector<std::string> reasons = differences(earlier.run, run, "then", "now");
  if (!reasons.empty()) return reasons;
  if (earlier.writers.size() != writers.size()) {
    return {"the manifest lists " + std::to_string(earlier.writers.size()) +
            " writers, and there " + "are " + std::to_string(writers.size()) + " now"};
  }
  for (std::size_t i = 0; i < std::min(writers.size(), earlier.writers.size()); ++i) {
    const std::string& then = earlier.writers[i].output_folder;
    if (then == writers[i].output_folder) continue;
    reasons.push_back(writers[i].name + "/output_folder: then '" + then + "', now '" +
                      writers[i].output_folder + "'");
  }
  if (reasons.empty() && !earlier.is_current) {
    reasons.emplace_back("its manifest has another format version");
  }
  return reasons;
}

/// Throws unless the existing dataset was begun with the same settings.
void requireSameRun(const ManifestContent& earlier, const std::string& folder,
                    const std::vector<StoreWriter>& writers, const RunDescription& run) {
  std::vector<std::string> reasons = reasonsNotToResume(earlier, writers, run);
  if (reasons.empty()) return;
  const std::string state = earlier.complete ? "is complete" : "was begun";
  for (std::string& reason : reasons) {
    reason = "the dataset in '" + folder + "' " + state + " with other settings: " + reason;
  }
  reasons.back() += "; set `if_exists: overwrite` to replace it, or choose another output_folder";
  throw ErrorList(reasons);
}

/// The manifest of the shard that a lock or pending file belongs to; empty for any other file.
std::string shardManifestOf(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  for (const std::string end : {".lock", ".tmp"}) {
    if (name.size() <= end.size() || name.front() != '.') continue;
    const std::size_t size = name.size() - end.size();
    const std::string manifest = name.substr(1, size - 1);
    if (name.compare(size, end.size(), end) == 0 && shardOfManifest(manifest)) {
      return (file.parent_path() / manifest).string();
    }
  }
  return "";
}

/// Removes what shard runs left behind if they were killed before they had a manifest; otherwise
/// only a run of the same shard would ever clean it up.
void removeLeftOfShards(const std::string& folder) {
  namespace fs = std::filesystem;
  std::set<std::string> manifests;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string manifest = shardManifestOf(entry->path());
    if (!manifest.empty() && !fs::exists(manifest)) manifests.insert(manifest);
  }
  for (const std::string& manifest : manifests) {
    try {
      const RunLock lock_of_the_dead(manifest);
      fs::remove(temporaryPath(manifest), error);
    } catch (const Error&) {  // that run is still alive
    }
  }
}

/// Makes sure that the run can begin, and only then removes what the run is to replace.
/// @return the lock of the new run's manifest
std::unique_ptr<RunLock> clearTheWay(const StoreOptions& options, const EarlierDataset& earlier,
                                     const std::vector<StoreWriter>& writers) {
  const std::string manifest = manifestFile(options.folder, options.shard);
  std::vector<std::string> problems = layoutProblems(manifest, writers);
  append(problems, earlier.obstacles(writers, options.if_exists, options.source));
  FolderProbe probe;
  makeFolders(options.folder, writers, probe);
  append(problems, probe.problems());
  if (!problems.empty()) throw ErrorList(problems);

  auto lock = std::make_unique<RunLock>(manifest);
  if (options.if_exists == IfExists::kOverwrite) earlier.remove();
  if (!options.shard) removeLeftOfShards(options.folder);
  makeFolders(options.folder, writers, probe);  // again: empty ones were removed above
  if (!probe.problems().empty()) throw ErrorList(probe.problems());
  probe.keepFolders();
  return lock;
}

/// The existing dataset. If its manifest cannot be read, throws that along with layout problems.
EarlierDataset findEarlier(const StoreOptions& options, const std::vector<StoreWriter>& writers) {
  try {
    return {options.folder, options.shard};
  } catch (const Error& error) {
    std::vector<std::string> problems =
        layoutProblems(manifestFile(options.folder, options.shard), writers);
    problems.emplace_back(error.what());
    throw ErrorList(problems);
  }
}

/// Removes the lock of a run that was killed after its dataset was already complete.
void removeLeftLock(const std::string& manifest) {
  if (!std::filesystem::exists(RunLock::fileOf(manifest))) return;
  try {
    const RunLock lock_of_the_dead(manifest);
  } catch (const Error&) {
    // That run is still alive, or the folder is not writable; neither matters here.
  }
}

void requireFolders(const std::string& folder, const std::vector<StoreWriter>& writers) {
  FolderProbe probe;
  makeFolders(folder, writers, probe);
  if (!probe.problems().empty()) throw ErrorList(probe.problems());
  probe.keepFolders();
}

/// Whether there is nothing left to do. Only checks that the files exist; `verify` reads them.
bool isWhole(const ManifestContent& dataset) {
  return dataset.complete &&
         std::all_of(dataset.files.begin(), dataset.files.end(), [](const std::string& file) {
           std::error_code error;
           return std::filesystem::exists(file, error);
         });
}

/// Refuses files that do not belong to the run: resuming a dataset removes and replaces its files.
void refuseForeignFiles(const ManifestContent& earlier, const std::string& folder,
                        const std::vector<StoreWriter>& writers) {
  const std::vector<std::string> foreign = filesOutsideRun(earlier, folder, writers);
  if (foreign.empty()) return;
  throw Error("the dataset in '" + folder + "' lists files outside of it that are not this " +
              "run's (" + firstNames(foreign) +
              "); remove that dataset by hand, or choose another output_folder");
}

OpenedDataset resume(const StoreOptions& options, const std::vector<StoreWriter>& writers,
                     const ManifestContent& earlier) {
  refuseForeignFiles(earlier, options.folder, writers);
  OpenedDataset opened{manifestFile(options.folder, options.shard), nullptr, nullptr};
  if (isWhole(earlier)) {
    removeLeftLock(opened.file);
    return opened;
  }
  requireFolders(options.folder, writers);
  auto lock = std::make_unique<RunLock>(opened.file);
  // The run that held the lock until now may have finished.
  if (isWhole(readManifest(opened.file))) return opened;
  opened.lock = std::move(lock);
  opened.manifest =
      std::make_unique<Manifest>(Manifest::open(options.folder, options.shard, options.sync));
  if (!options.shard) removeLeftOfShards(options.folder);
  if (earlier.complete) opened.manifest->reopen();
  dropUnfinished(*opened.manifest);
  return opened;
}

OpenedDataset open(const StoreOptions& options, const std::vector<StoreWriter>& writers,
                   const RunDescription& run) {
  const EarlierDataset earlier = findEarlier(options, writers);
  const bool resumes = options.if_exists == IfExists::kResume;
  if (resumes && earlier.own() != nullptr) {
    requireSameRun(*earlier.own(), options.folder, writers, run);
    return resume(options, writers, *earlier.own());
  }
  if (resumes && earlier.whole() != nullptr && earlier.whole()->complete) {
    requireSameRun(*earlier.whole(), options.folder, writers, run);
    return {manifestFile(options.folder), nullptr, nullptr};
  }
  OpenedDataset opened{manifestFile(options.folder, options.shard), nullptr, nullptr};
  opened.lock = clearTheWay(options, earlier, writers);
  opened.manifest = std::make_unique<Manifest>(
      Manifest::create(options.folder, options.shard, options.sync, writers, run));
  return opened;
}

}  // namespace

void makeAbsolute(StoreOptions& options, std::vector<StoreWriter>& writers) {
  options.folder = withoutTrailingSlash(absolutePath(options.folder));
  for (StoreWriter& writer : writers) {
    writer.output_folder = withoutTrailingSlash(absolutePath(writer.output_folder)) + "/";
    for (std::string& file : writer.user_files) file = absolutePath(file);
  }
}

std::optional<EarlierRun> findEarlierRun(StoreOptions options, std::vector<StoreWriter> writers,
                                         RunDescription run) {
  makeAbsolute(options, writers);
  const std::string manifest = manifestFile(options.folder, options.shard);
  std::error_code error;  // set for an unreadable folder; whoever needs the folder reports it
  if (!std::filesystem::exists(manifest, error)) return std::nullopt;
  EarlierRun found;
  found.is_written = RunLock::isHeld(manifest);
  if (found.is_written) return found;
  try {
    const ManifestContent earlier = readManifest(manifest, ManifestFiles::kLeftOut);
    // Only the process that renders knows the OpenGL version, and it has not started yet.
    const auto opengl = earlier.run.software.find("opengl");
    if (opengl != earlier.run.software.end()) run.software.insert(*opengl);
    found.complete = earlier.complete;
    found.scene_count = earlier.scene_count;
    found.differences = reasonsNotToResume(earlier, writers, run);
  } catch (const Error& fault) {
    found.fault = fault.what();
  }
  return found;
}

std::vector<std::string> filesInTheWay(StoreOptions options, std::vector<StoreWriter> writers) {
  makeAbsolute(options, writers);
  std::error_code error;
  const bool has_dataset =
      std::filesystem::exists(manifestFile(options.folder, options.shard), error);
  if (has_dataset && options.if_exists != IfExists::kOverwrite) return {};
  try {
    return EarlierDataset(options.folder, options.shard)
        .obstacles(writers, options.if_exists, options.source);
  } catch (const Error&) {
    return {};  // findEarlierRun reports it
  }
}

OpenedDataset openDataset(const StoreOptions& options, const std::vector<StoreWriter>& writers,
                          const RunDescription& run) {
  try {
    return open(options, writers, run);
  } catch (const ErrorList&) {
    throw;
  } catch (const Error& error) {
    throw ErrorList({error.what()});
  }
}

}  // namespace synthetic_dataset::output
