#include "reference/reference_worlds.h"

#include <algorithm>
#include <cstdlib>
#include <set>

#include "reference/reference_folder.h"
#include "world/world_loader.h"

namespace synthetic_dataset::test {
namespace {

namespace fs = std::filesystem;

/// The folders that hold models, and those of packages.
struct Folders {
  std::set<std::string> models;
  std::set<std::string> packages;
};

Folders foldersBelow(const fs::path& root) {
  Folders folders;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const fs::path folder = entry.path().parent_path();
    if (entry.path().filename() == "model.config") {
      folders.models.insert(folder.parent_path().string());
    } else if (entry.path().filename() == "package.xml") {
      folders.packages.insert(folder.string());
      folders.models.insert(folder.parent_path().string());
    }
  }
  return folders;
}

std::string joined(const std::set<std::string>& folders) {
  std::string text;
  for (const std::string& folder : folders) text += (text.empty() ? "" : ":") + folder;
  return text;
}

std::string worldFileOf(const fs::path& root, const std::string& name) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const std::string file = entry.path().filename().string();
    if (file == name + ".world" || file == name + ".sdf") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end(), [](const std::string& a, const std::string& b) {
    const bool a_world = fs::path(a).extension() == ".world";
    const bool b_world = fs::path(b).extension() == ".world";
    return a_world != b_world ? a_world : a < b;
  });
  return files.empty() ? "" : files.front();
}

}  // namespace

std::vector<ReferenceWorld> referenceWorlds() {
  std::vector<ReferenceWorld> worlds;
  const fs::path gazebo = referenceFolder() / "gazebo";
  for (const auto& entry : fs::recursive_directory_iterator(gazebo / "reference")) {
    if (entry.path().filename() != "state.json") continue;
    ReferenceWorld world;
    world.reference = entry.path().parent_path();
    const std::string name = world.reference.filename().string();
    const std::string repository = world.reference.parent_path().filename().string();
    world.name = repository + "/" + name;
    if (repository == "models") {
      world.root = referenceFolder() / "models/gazebo";
      world.uri = "model://" + name;
    } else {
      world.root =
          repository == "chart" ? gazebo / "chart" : referenceFolder() / "worlds" / repository;
      world.uri = worldFileOf(world.root, name);
    }
    worlds.push_back(world);
  }
  std::sort(worlds.begin(), worlds.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  return worlds;
}

world::ResourceFinder finderFor(const fs::path& root) {
  const Folders folders = foldersBelow(root);
  setenv("GAZEBO_RESOURCE_PATH", joined(folders.packages).c_str(), 1);
  return world::ResourceFinder({folders.models.begin(), folders.models.end()}, nullptr);
}

world::Description loadReferenceWorld(const ReferenceWorld& world) {
  const world::ResourceFinder finder = finderFor(world.root);
  world::LoadOptions options;
  options.on_missing_asset = world::OnMissingAsset::kWarn;
  return world::loadWorld(world.uri, finder, options);
}

}  // namespace synthetic_dataset::test
