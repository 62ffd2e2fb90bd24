#include "output/earlier_dataset.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "output/file_name_rules.h"
#include "output/pending_file.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kNamedFiles = 3;  // of a folder, in a message

bool isThere(const std::string& path) {
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

/// "'a', 'b', 'c' and more"
std::string quotedList(const std::vector<std::string>& names) {
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), kNamedFiles); ++i) {
    list += (i == 0 ? "'" : ", '") + names[i] + "'";
  }
  return names.size() > kNamedFiles ? list + " and more" : list;
}

}  // namespace

EarlierDataset::EarlierDataset(const std::string& folder) : folder_(folder) {
  const std::string manifest = manifestFile(folder_);
  exists_ = isThere(manifest);
  if (!exists_) return;
  content_ = readManifest(folder_);
  for (const std::string& file : content_.files) {
    known_files_.insert(file);
    known_files_.insert(temporaryPath(file));
  }
  known_files_.insert(manifest);
  known_files_.insert(manifest + "-journal");
}

std::vector<std::string> EarlierDataset::obstacles(const std::vector<StoreWriter>& writers,
                                                   IfExists if_exists) const {
  std::vector<std::string> obstacles;
  if (exists_ && if_exists == IfExists::kError) {
    obstacles.push_back("'" + manifestFile(folder_) + "' lists " +
                        (content_.complete ? "a complete" : "an unfinished") + " dataset of " +
                        std::to_string(content_.scene_count) +
                        " scenes; choose another folder, or set `if_exists: overwrite` to replace "
                        "that dataset");
  }
  for (const StoreWriter& writer : writers) {
    const std::vector<std::string> unlisted = unlistedFiles(writer);
    if (!unlisted.empty()) {
      obstacles.push_back("writer '" + writer.name + "': the folder '" + writer.output_folder +
                          "' holds files that no manifest lists (" + quotedList(unlisted) +
                          "); choose another output_folder, or move them away "
                          "(`if_exists: overwrite` replaces only what a manifest lists)");
    }
    for (const std::string& file : writer.user_files) {
      std::error_code error;
      if (fs::is_directory(file, error)) {
        obstacles.push_back("writer '" + writer.name + "': '" + file +
                            "' is a folder; it should be the path of a file");
      } else if (if_exists == IfExists::kError && known_files_.count(file) == 0 && isThere(file)) {
        obstacles.push_back("writer '" + writer.name + "': the file '" + file +
                            "' exists; choose another path, or set `if_exists: overwrite` to "
                            "replace it");
      }
    }
  }
  return obstacles;
}

std::vector<std::string> EarlierDataset::unlistedFiles(const StoreWriter& writer) const {
  std::vector<std::string> unlisted;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(writer.output_folder, error), end;
       !error && entry != end; entry.increment(error)) {
    std::error_code ignored;
    if (entry->symlink_status(ignored).type() == fs::file_type::directory) continue;
    const std::string path = entry->path().string();
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
  if (!exists_) return;
  std::vector<std::string> failures;
  const auto removeFile = [&failures](const std::string& file) {
    // unlink(2) removes no folder, whatever a manifest says.
    if (::unlink(file.c_str()) != 0 && errno != ENOENT && errno != ENOTDIR) {
      failures.push_back("cannot remove '" + file + "': " + std::generic_category().message(errno));
    }
  };
  for (const std::string& file : content_.files) {
    removeFile(file);
    removeFile(temporaryPath(file));
    removeEmptyFoldersAbove(file);
  }
  for (const std::string& folder : content_.writer_folders) removeEmptyFoldersAbove(folder);
  // The manifest stays as long as there is something that it lists.
  if (failures.empty()) {
    const std::string manifest = manifestFile(folder_);
    removeFile(manifest + "-journal");
    removeFile(manifest);
  }
  if (!failures.empty()) throw ErrorList(failures);
}

void EarlierDataset::removeEmptyFoldersAbove(const std::string& file) const {
  const auto isOfAWriter = [this](const std::string& folder) {
    return std::any_of(content_.writer_folders.begin(), content_.writer_folders.end(),
                       [&](const std::string& writers) { return liesWithin(folder, writers); });
  };
  fs::path folder = fs::path(file).parent_path();
  while (isOfAWriter(folder.string()) && ::rmdir(folder.c_str()) == 0) {
    folder = folder.parent_path();
  }
}

}  // namespace synthetic_dataset::output
