#include "ros_packages.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <rospack/rospack.h>

namespace synthetic_dataset {

world::ResourceFinder::PackageFinder rosPackageFinder() {
  auto packages = std::make_shared<rospack::Rospack>();
  packages->setQuiet(true);
  std::vector<std::string> search_path;
  if (packages->getSearchPathFromEnv(search_path)) packages->crawl(search_path, false);
  return [packages](const std::string& package) -> std::optional<std::string> {
    std::string folder;
    if (!packages->find(package, folder) || folder.empty()) return std::nullopt;
    return folder;
  };
}

}  // namespace synthetic_dataset
