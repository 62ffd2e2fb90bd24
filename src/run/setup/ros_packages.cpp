#include "run/setup/ros_packages.h"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <rospack/rospack.h>

#include "output/writers/package_path.h"

namespace synthetic_dataset::run {
namespace {

/// The folders of packages, by their names. Looking through all takes a while: it is done when the
/// first one is asked for, and once more when one is missing, for rospack remembers for a minute
/// what it found. (rospack itself looks through all again for each name that it does not know.)
class PackageFolders {
 public:
  [[nodiscard]] std::optional<std::string> find(const std::string& package) {
    for (; looks_ < 2; look()) {
      if (const auto folder = known(package)) return folder;
    }
    return known(package);
  }

 private:
  [[nodiscard]] std::optional<std::string> known(const std::string& package) const {
    const auto found = folders_.find(package);
    if (found == folders_.end() || found->second.empty()) return std::nullopt;
    return found->second;
  }

  void look() {
    rospack::Rospack packages;
    packages.setQuiet(true);
    std::vector<std::string> search_path;
    std::set<std::pair<std::string, std::string>> found;
    if (packages.getSearchPathFromEnv(search_path)) {
      packages.crawl(search_path, looks_ > 0);
      packages.list(found);
    }
    folders_ = {found.begin(), found.end()};
    ++looks_;
  }

  std::map<std::string, std::string> folders_;
  int looks_ = 0;
};

}  // namespace

world::ResourceFinder::PackageFinder rosPackageFinder() {
  output::shortenPackageSearch();
  return [folders = std::make_shared<PackageFolders>()](const std::string& package) {
    return folders->find(package);
  };
}

}  // namespace synthetic_dataset::run
