/// Models of Gazebo's library, each as a world by itself.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "reference/golden_case.h"
#include "support/description_text.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"
#include "world/sdf/model_config.h"
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

/// Gazebo draws these and libsdformat refuses them: for a joint to a nested link by its old name, a
/// friction below 0, and an attribute without quotes.
const std::set<std::string> kRefused = {"drc_practice_handle_wheel_valve_wall", "ragdoll",
                                        "submarine"};

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

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

TEST(ReferenceModels, LoadAsWorlds) {
  for (const std::string& name : modelNames()) {
    if (kIncomplete.count(name) != 0 || kRefused.count(name) != 0) continue;
    for (const auto mode : {world::OnMissingAsset::kError, world::OnMissingAsset::kWarn}) {
      const world::Description world = loadModelNamed(name, mode);
      EXPECT_EQ(world.models.size() + world.lights.size(), 1U) << name;
      EXPECT_THAT(world.notes, Each(Not(HasSubstr("(left out)")))) << name;
    }
  }
}

/// A world that draws a model in twice, in the model's own version of SDF.
world::Description loadIncluded(const std::string& name, const std::string& attributes) {
  const std::string own = contentOf(world::modelFileOf(modelsFolder() / name));
  std::smatch version;
  std::regex_search(own, version, std::regex("<sdf version=['\"]([^'\"]*)"));
  const std::string include = "<include " + attributes + "><uri>model://" + name + "</uri><name>";
  const test::TemporaryFolder folder;
  const auto file = folder.write(
      "world.sdf", "<sdf version='" + version.str(1) + "'><world name='w'>" + include +
                       "a</name></include>" + include +
                       "b</name><pose>1 2 3 0.1 0.2 0.3</pose><static>true</static></include>" +
                       "</world></sdf>");
  const world::ResourceFinder finder({modelsFolder().string()}, nullptr);
  world::LoadOptions options;
  options.on_missing_asset = world::OnMissingAsset::kWarn;
  return world::loadWorld(file.string(), finder, options);
}

TEST(ReferenceModels, AreTheSameJoinedToAWorldAndIncluded) {
  for (const std::string& name : modelNames()) {
    if (kRefused.count(name) != 0) continue;
    const std::string joined = test::textOf(loadIncluded(name, ""));
    EXPECT_NE(joined, "") << name;
    EXPECT_EQ(joined, test::textOf(loadIncluded(name, "merge='false'"))) << name;
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

TEST(ReferenceModels, AreRefusedWhereLibsdformatCannotReadThem) {
  for (const std::string& name : kRefused) {
    EXPECT_THROW(static_cast<void>(loadModelNamed(name, world::OnMissingAsset::kWarn)), ErrorList)
        << name;
  }
}

}  // namespace models_test
}  // namespace synthetic_dataset
