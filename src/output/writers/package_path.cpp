#include "output/writers/package_path.h"

#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <vector>

namespace synthetic_dataset::output {
namespace {

namespace fs = std::filesystem;

/// The folders of packages in a `share` folder, sorted; none if it cannot be read.
std::vector<std::string> packagesIn(const fs::path& share) {
  std::vector<std::string> packages;
  std::error_code error;
  for (auto entry = fs::directory_iterator(share, error); !error && entry != end(entry);
       entry.increment(error)) {
    std::error_code unknown;
    if (fs::exists(entry->path() / "package.xml", unknown)) packages.push_back(entry->path());
  }
  std::sort(packages.begin(), packages.end());
  return packages;
}

}  // namespace

std::string withSharedPackages(const std::string& package_path) {
  std::string result;
  const auto add = [&](const std::string& entry) { result += (result.empty() ? "" : ":") + entry; };
  std::istringstream entries(package_path);
  for (std::string entry; std::getline(entries, entry, ':');) {
    const std::vector<std::string> packages =
        fs::path(entry).filename() == "share" ? packagesIn(entry) : std::vector<std::string>();
    if (packages.empty()) {
      add(entry);
    } else {
      std::for_each(packages.begin(), packages.end(), add);
    }
  }
  return result;
}

void shortenPackageSearch() {
  const char* path = getenv("ROS_PACKAGE_PATH");
  if (path != nullptr) setenv("ROS_PACKAGE_PATH", withSharedPackages(path).c_str(), 1);
}

}  // namespace synthetic_dataset::output
