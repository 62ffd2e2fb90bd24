#include "output/file_checks.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "output/files/digest.h"
#include "output/files/file_name_rules.h"
#include "output/files/pending_file.h"
#include "output/files/run_lock.h"
#include "output/manifest/manifest_paths.h"
#include "output/manifest/manifest_schema.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

namespace fs = std::filesystem;

std::string contentProblem(const std::string& path, const ListedFile& file) {
  try {
    const FileDigest found = digestOfFile(path);
    if (found.digest == file.digest) return "";
    return "is changed: found the SHA-256 " + found.digest + "; it should be " + file.digest;
  } catch (const Error& error) {
    return error.what();
  }
}

const char* kindOf(fs::file_type type) {
  return type == fs::file_type::directory ? "a folder"
         : type == fs::file_type::symlink ? "a symbolic link"
                                          : "not a regular file";
}

/// The files beside a manifest that belong to it, and the report page.
std::vector<std::string> companionsOf(const std::string& manifest) {
  const std::string report = reportFile(fs::path(manifest).parent_path().string());
  return {manifest,
          manifest + "-journal",
          manifest + "-wal",
          manifest + "-shm",
          temporaryPath(manifest),
          RunLock::fileOf(manifest),
          report,
          temporaryPath(report)};
}

void add(const std::string& file, FewFiles& files) {
  constexpr std::size_t kNamed = 3;
  ++files.count;
  auto& named = files.named;
  named.insert(std::upper_bound(named.begin(), named.end(), file), file);
  if (named.size() > kNamed) named.pop_back();
}

}  // namespace

FileFinding checkFile(const std::string& path, const std::string& linked_to, const ListedFile& file,
                      FileCheck how) {
  std::error_code error;
  const fs::file_type type = fs::symlink_status(path, error).type();
  if (type == fs::file_type::not_found) return {"is missing", false};
  if (type == fs::file_type::none) return {"cannot be examined: " + error.message(), false};
  if (type != fs::file_type::regular) {
    return {std::string("is ") + kindOf(type) + "; it should be a file of " +
                std::to_string(file.bytes) + " bytes",
            false};
  }
  const auto size = static_cast<std::int64_t>(fs::file_size(path, error));
  if (error) return {"cannot be examined: " + error.message(), false};
  if (size != file.bytes) {
    return {std::string(size < file.bytes ? "is cut short" : "is too long") + ": found " +
                std::to_string(size) + " bytes; it should have " + std::to_string(file.bytes),
            false};
  }
  // If both are names of the same file, only the other one is read.
  const bool is_same = !linked_to.empty() && fs::equivalent(path, linked_to, error);
  if (how == FileCheck::kSize || is_same) return {};
  return {contentProblem(path, file), true};
}

std::string pathProblem(const ListedFile& file, const WrittenDataset& dataset) {
  std::string path;
  try {
    path = absoluteFrom(dataset.folder(), file.path);
  } catch (const Error&) {
    return "leads out of the dataset";
  }
  if (path.empty() || path.back() == '/' || absolutePath(path) != path) {
    return "is not the path of a file";
  }
  // Files of the dataset as a whole may be anywhere, since the user names some of them.
  const auto& writers = dataset.content().writers;
  if (!file.scene || file.writer >= writers.size()) return "";
  const StoreWriter& writer = writers[file.writer];
  if (liesWithin(path, writer.output_folder)) return "";
  return "is not in the folder of its writer '" + writer.name + "', '" + writer.output_folder + "'";
}

StrayFiles strayFiles(const std::string& folder,
                      const std::vector<const WrittenDataset*>& datasets) {
  std::set<std::string> companions;
  for (const WrittenDataset* dataset : datasets) {
    for (std::string& file : companionsOf(dataset->manifest())) companions.insert(std::move(file));
  }
  const auto isKnown = [&](const std::string& path) {
    return companions.count(path) != 0 ||
           std::any_of(datasets.begin(), datasets.end(),
                       [&](const WrittenDataset* dataset) { return dataset->lists(path); });
  };
  const auto isTemporary = [&](const std::string& path) {
    return std::any_of(datasets.begin(), datasets.end(), [&](const WrittenDataset* dataset) {
      return dataset->listsTemporary(path);
    });
  };
  StrayFiles stray;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    if (entry->symlink_status(ignored).type() == fs::file_type::directory) continue;
    const std::string path = entry->path().string();
    if (!isKnown(path)) add(path, isTemporary(path) ? stray.half_written : stray.unlisted);
  }
  return stray;
}

}  // namespace synthetic_dataset::output
