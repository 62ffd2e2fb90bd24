#include "world/files/gazebo_folders.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <system_error>
#include <utility>

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

/// gazebo-11 before gazebo-9, and before gazebo, which is a link.
bool isNewer(const fs::path& a, const fs::path& b) {
  return std::make_pair(a.string().size(), a.string()) >
         std::make_pair(b.string().size(), b.string());
}

std::vector<fs::path> gazebosIn(const fs::path& share) {
  std::vector<fs::path> folders;
  std::error_code error;
  for (fs::directory_iterator entry(share, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().filename().string().rfind("gazebo", 0) != 0) continue;
    std::error_code ignored;
    if (fs::is_directory(entry->path() / "media", ignored)) folders.push_back(entry->path());
  }
  std::sort(folders.begin(), folders.end(), isNewer);
  return folders;
}

}  // namespace

std::vector<std::string> foldersOf(const char* variable) {
  std::vector<std::string> folders;
  const char* value = std::getenv(variable);
  std::istringstream list(value != nullptr ? value : "");
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) folders.push_back(folder);
  }
  return folders;
}

std::vector<fs::path> installedGazebos() {
  std::vector<fs::path> shares = {"/usr/local/share", "/usr/share"};
  const char* conda = std::getenv("CONDA_PREFIX");
  if (conda != nullptr && *conda != '\0') shares.push_back(fs::path(conda) / "share");
  std::vector<fs::path> folders;
  for (const fs::path& share : shares) {
    for (fs::path& folder : gazebosIn(share)) folders.push_back(std::move(folder));
  }
  return folders;
}

}  // namespace synthetic_dataset::world
