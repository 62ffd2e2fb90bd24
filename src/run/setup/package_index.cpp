#include "run/setup/package_index.h"

#include <algorithm>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "base/ros_packages.h"

namespace synthetic_dataset::run {

struct RosPackageIndex::Found {
  std::mutex mutex;
  std::optional<base::RosPackages> packages;

  const base::RosPackages& get() {
    const std::lock_guard<std::mutex> lock(mutex);
    if (!packages) packages = base::findRosPackages(base::rosPackagePath());
    return *packages;  // not changed any more
  }
};

RosPackageIndex::RosPackageIndex() : found_(std::make_shared<Found>()) {}

world::ResourceFinder::PackageFinder RosPackageIndex::finder() const {
  return [found = found_](const std::string& package) -> std::optional<std::string> {
    const std::vector<base::RosPackage>& all = found->get().sound;
    const auto match = std::find_if(
        all.begin(), all.end(), [&](const base::RosPackage& each) { return each.name == package; });
    if (match == all.end()) return std::nullopt;
    return match->folder.string();
  };
}

world::ResourceFinder::ExportFinder RosPackageIndex::exports() const {
  return [found = found_] {
    world::ExportedFolders folders;
    for (const base::RosPackage& package : found->get().sound) {
      const auto append = [](const auto& from, auto& to) {
        to.insert(to.end(), from.begin(), from.end());
      };
      append(package.gazebo_models, folders.models);
      append(package.gazebo_media, folders.media);
    }
    return folders;
  };
}

std::vector<std::string> RosPackageIndex::notes() const {
  const std::lock_guard<std::mutex> lock(found_->mutex);
  std::vector<std::string> notes;
  if (!found_->packages) return notes;
  for (const auto& [folder, reason] : found_->packages->broken) {
    notes.push_back(reason + "; the package is ignored");
  }
  return notes;
}

world::ResourceFinder::PackageFinder rosPackageFinder() { return RosPackageIndex().finder(); }

}  // namespace synthetic_dataset::run
