/// Models of Gazebo's library, each as a world by itself.

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "reference/reference_folder.h"
#include "synthetic_dataset/errors.h"
#include "world/world_loader.h"

namespace synthetic_dataset {
namespace models_test {

namespace fs = std::filesystem;

using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Include models, or name textures, that the folder lacks.
const std::set<std::string> kIncomplete = {"drc_practice_angled_barrier_45", "house_3"};

fs::path modelsFolder() { return test::referenceFolder() / "models/gazebo"; }

std::vector<std::string> modelNames() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(modelsFolder())) {
    if (fs::exists(entry.path() / "model.config"))
      names.push_back(entry.path().filename().string());
  }
  return names;
}

world::Description loadModelNamed(const std::string& name, world::OnMissingAsset on_missing_asset) {
  const world::ResourceFinder finder({modelsFolder().string()}, nullptr);
  world::LoadOptions options;
  options.on_missing_asset = on_missing_asset;
  return world::loadWorld("model://" + name, finder, options);
}

TEST(ReferenceModels, LoadAsWorlds) {
  for (const std::string& name : modelNames()) {
    if (kIncomplete.count(name) != 0) continue;
    for (const auto mode : {world::OnMissingAsset::kError, world::OnMissingAsset::kWarn}) {
      const world::Description world = loadModelNamed(name, mode);
      EXPECT_EQ(world.models.size() + world.lights.size(), 1U) << name;
      EXPECT_THAT(world.notes, Each(Not(HasSubstr("(left out)")))) << name;
    }
  }
}

TEST(ReferenceModels, NameWhatIsMissing) {
  for (const std::string& name : kIncomplete) {
    try {
      static_cast<void>(loadModelNamed(name, world::OnMissingAsset::kError));
      FAIL() << name;
    } catch (const ErrorList& errors) {
      EXPECT_THAT(errors.messages(), Not(IsEmpty()));
      EXPECT_THAT(errors.messages(), Each(HasSubstr("no such file; looked in ")));
    }
  }
}

TEST(ReferenceModels, LoadWithoutWhatIsMissing) {
  for (const std::string& name : kIncomplete) {
    const world::Description world = loadModelNamed(name, world::OnMissingAsset::kWarn);
    EXPECT_EQ(world.models.size(), 1U) << name;
    EXPECT_THAT(world.notes, testing::Contains(HasSubstr("(left out)"))) << name;
  }
}

}  // namespace models_test
}  // namespace synthetic_dataset
