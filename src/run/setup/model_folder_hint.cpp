#include "run/setup/model_folder_hint.h"

#include <algorithm>
#include <cstddef>
#include <system_error>
#include <vector>

namespace synthetic_dataset::run {
namespace {

namespace fs = std::filesystem;

bool isFolder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

/// The folders in a folder, in alphabetical order.
std::vector<fs::path> foldersIn(const fs::path& folder) {
  constexpr std::size_t kMost = 500;  // a larger one is not a workspace
  std::vector<fs::path> folders;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (const fs::directory_iterator end; !error && entry != end && folders.size() < kMost;
       entry.increment(error)) {
    if (isFolder(entry->path())) folders.push_back(entry->path());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

/// The part of a URI after "model://" or "package://", such as "shelf/meshes/shelf.dae"; empty for
/// other URIs.
fs::path placeInModels(const std::string& uri) {
  for (const char* scheme : {"model://", "package://"}) {
    if (uri.rfind(scheme, 0) != 0) continue;
    const fs::path place = uri.substr(std::string(scheme).size());
    const bool leads_out = std::find(place.begin(), place.end(), "..") != place.end();
    return place.is_absolute() || leads_out ? fs::path() : place;
  }
  return {};
}

/// From nearest to farthest: the world's folder and those above it, their subfolders, and the
/// subfolders of these that are called `models`.
std::vector<fs::path> foldersNear(const fs::path& world_file) {
  constexpr int kNearLevels = 3;
  std::vector<fs::path> near;
  std::error_code error;
  fs::path level = fs::absolute(world_file, error).lexically_normal().parent_path();
  for (int i = 0; i < kNearLevels && level.has_relative_path(); ++i, level = level.parent_path()) {
    near.push_back(level);
    for (const fs::path& each : foldersIn(level)) {
      near.push_back(each);
      if (isFolder(each / "models")) near.push_back(each / "models");
    }
  }
  return near;
}

}  // namespace

std::string modelFolderHint(const fs::path& world_file, const std::set<std::string>& uris) {
  std::set<fs::path> places;
  for (const std::string& uri : uris) {
    if (const fs::path place = placeInModels(uri); !place.empty()) places.insert(place);
  }
  if (places.empty()) return "";
  fs::path best;
  std::ptrdiff_t most = 0;
  for (const fs::path& folder : foldersNear(world_file)) {
    const std::ptrdiff_t count =
        std::count_if(places.begin(), places.end(), [&](const fs::path& place) {
          std::error_code ignored;
          return fs::exists(folder / place, ignored);
        });
    if (count <= most) continue;
    most = count;
    best = folder;
  }
  if (most == 0) return "";
  return "world/model_folders: '" + best.string() + "' has " +
         (most == 1 ? "one" : std::to_string(most)) +
         " of the missing models and files; it should be listed here, or in GAZEBO_MODEL_PATH";
}

}  // namespace synthetic_dataset::run
