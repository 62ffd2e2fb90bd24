#include "ros_packages.h"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <rospack/rospack.h>

#include "writers/package_path.h"

namespace synthetic_dataset {
namespace {

/// Of all packages, by their names.
std::map<std::string, std::string> packageFolders() {
  rospack::Rospack packages;
  packages.setQuiet(true);
  std::vector<std::string> search_path;
  std::set<std::pair<std::string, std::string>> found;
  if (packages.getSearchPathFromEnv(search_path)) {
    packages.crawl(search_path, false);
    packages.list(found);
  }
  return {found.begin(), found.end()};
}

}  // namespace

world::ResourceFinder::PackageFinder rosPackageFinder() {
  writers::shortenPackageSearch();
  // Looking through all packages takes a while: only when one is asked for, and only once. (rospack
  // itself looks again for each name that it does not know.)
  auto folders = std::shared_ptr<std::map<std::string, std::string>>();
  return [folders](const std::string& package) mutable -> std::optional<std::string> {
    if (folders == nullptr) {
      folders = std::make_shared<std::map<std::string, std::string>>(packageFolders());
    }
    const auto found = folders->find(package);
    if (found == folders->end() || found->second.empty()) return std::nullopt;
    return found->second;
  };
}

}  // namespace synthetic_dataset
