#include "world/material/gazebo_media.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <system_error>

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

constexpr const char* kShare = "/usr/share";

/// Where Debian's packages put Gazebo: /usr/share/gazebo-11, and /usr/share/gazebo for a link.
std::vector<fs::path> installedFolders() {
  std::vector<fs::path> folders;
  std::error_code error;
  for (fs::directory_iterator entry(kShare, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().filename().string().rfind("gazebo", 0) != 0) continue;
    std::error_code ignored;
    if (fs::is_directory(entry->path() / "media", ignored)) folders.push_back(entry->path());
  }
  std::sort(folders.begin(), folders.end(), [](const fs::path& a, const fs::path& b) {
    return std::make_pair(a.string().size(), a.string()) >
           std::make_pair(b.string().size(), b.string());  // gazebo-11 before gazebo-9
  });
  return folders;
}

}  // namespace

std::vector<fs::path> gazeboResourceFolders() {
  std::vector<fs::path> folders;
  const char* variable = std::getenv("GAZEBO_RESOURCE_PATH");
  std::istringstream list(variable != nullptr ? variable : "");
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) folders.emplace_back(folder);
  }
  for (fs::path& folder : installedFolders()) folders.push_back(std::move(folder));
  return folders;
}

std::optional<fs::path> findGazeboResource(const std::string& path) {
  for (const fs::path& folder : gazeboResourceFolders()) {
    const fs::path candidate = folder / fs::path(path).relative_path();
    std::error_code ignored;
    if (fs::exists(candidate, ignored)) return candidate;
  }
  return std::nullopt;
}

}  // namespace synthetic_dataset::world
