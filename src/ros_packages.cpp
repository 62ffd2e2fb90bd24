#include "ros_packages.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <rospack/rospack.h>

#include "writers/package_path.h"

namespace synthetic_dataset {

world::ResourceFinder::PackageFinder rosPackageFinder() {
  writers::shortenPackageSearch();
  // Looking through all packages takes seconds where they are many: only when one is asked for.
  auto packages = std::shared_ptr<rospack::Rospack>();
  return [packages](const std::string& package) mutable -> std::optional<std::string> {
    if (packages == nullptr) {
      packages = std::make_shared<rospack::Rospack>();
      packages->setQuiet(true);
      std::vector<std::string> search_path;
      if (packages->getSearchPathFromEnv(search_path)) packages->crawl(search_path, false);
    }
    std::string folder;
    if (!packages->find(package, folder) || folder.empty()) return std::nullopt;
    return folder;
  };
}

}  // namespace synthetic_dataset
