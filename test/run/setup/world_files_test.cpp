#include "run/setup/world_files.h"

#include <cstdlib>

#include <gmock/gmock.h>

#include "base/stages.h"
#include "support/error_messages.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::run {
namespace world_files_test {

using synthetic_dataset::test::messagesOf;
using test::TemporaryFolder;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string worldOf(const std::vector<std::string>& meshes) {
  std::string models;
  for (const std::string& mesh : meshes) {
    const std::string name = "m" + std::to_string(models.size());
    models += "<model name='" + name +
              "'><static>1</static><link name='l'><visual name='v'>"
              "<geometry><mesh><uri>" +
              mesh + "</uri></mesh></geometry></visual></link></model>";
  }
  return "<sdf version='1.6'><world name='w'>" + models + "</world></sdf>";
}

/// A world in a folder, with a ROS_PACKAGE_PATH of its own.
class WorldFilesTest : public testing::Test {
 protected:
  WorldFilesTest() { setenv("ROS_PACKAGE_PATH", (folder_ / "src").c_str(), 1); }
  ~WorldFilesTest() override { setenv("ROS_PACKAGE_PATH", path_.c_str(), 1); }

  config::WorldConfig configOf(const std::vector<std::string>& meshes) const {
    config::WorldConfig config;
    config.file = folder_.write("worlds/a.world", worldOf(meshes)).string();
    return config;
  }

  static std::string environmentsPath() {
    const char* path = std::getenv("ROS_PACKAGE_PATH");
    return path != nullptr ? path : "";
  }

  const std::string path_ = environmentsPath();
  TemporaryFolder folder_;
};

TEST_F(WorldFilesTest, SayHowToDoWithoutFilesThatAreMissing) {
  WorldFiles files(configOf({"a.dae", "b.dae", "a.dae"}), base::ignoreStage);
  EXPECT_THAT(messagesOf([&] { (void)files.world(); }),
              ElementsAre(HasSubstr("'a.dae': no such file"), HasSubstr("'b.dae': no such file"),
                          HasSubstr("2 files are missing or cannot be read; "
                                    "'world/on_missing_asset: warn' draws the rest")));
}

TEST_F(WorldFilesTest, SayWhichFolderNearbyHasTheModelsThatAreMissing) {
  (void)folder_.write("models/box/box.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  WorldFiles files(configOf({"model://box/box.obj"}), base::ignoreStage);
  EXPECT_THAT(messagesOf([&] { (void)files.world(); }),
              Contains("world/model_folders: '" + (folder_ / "models").string() +
                       "' has one of the missing models and files; it should be listed here, or in "
                       "GAZEBO_MODEL_PATH"));
}

TEST_F(WorldFilesTest, SuggestNoFolderThatIsSearchedAlready) {
  config::WorldConfig config = configOf({"model://box/gone.obj"});
  config.model_folders = {(folder_ / "models").string()};
  (void)folder_.write("models/box/model.config", "<model/>");
  WorldFiles files(config, base::ignoreStage);
  EXPECT_THAT(messagesOf([&] { (void)files.world(); }), Not(Contains(HasSubstr("model_folders:"))));
}

TEST_F(WorldFilesTest, RefuseToLeadOutOfModelsEvenWhereFilesMayBeMissing) {
  config::WorldConfig config = configOf({"model://a/../../secret.dae"});
  config.loading.on_missing_asset = world::OnMissingAsset::kWarn;
  WorldFiles files(config, base::ignoreStage);
  (void)files.world();
  EXPECT_THAT(files.refusals(), ElementsAre(HasSubstr("'model://a/../../secret.dae'")));
}

TEST_F(WorldFilesTest, FindWhatPackagesExportForGazebo) {
  (void)folder_.write("src/broken/package.xml", "<package>");
  (void)folder_.write("src/shop/package.xml",
                      "<package><name>shop</name><export><gazebo_ros "
                      "gazebo_model_path='${prefix}/models'/></export></package>");
  (void)folder_.write("src/shop/models/box/box.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  WorldFiles files(configOf({"model://box/box.obj"}), base::ignoreStage);
  EXPECT_EQ(files.world().models.at(0).links.at(0).visuals.size(), 1U);
  EXPECT_THAT(files.packageNotes(), ElementsAre(HasSubstr("src/broken/package.xml: line 1")));
}

TEST_F(WorldFilesTest, AskForNoPackagesWhereNothingIsMissing) {
  (void)folder_.write("src/broken/package.xml", "<package>");
  (void)folder_.write("worlds/box.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  WorldFiles files(configOf({"box.obj"}), base::ignoreStage);
  (void)files.world();
  EXPECT_THAT(files.packageNotes(), IsEmpty());
}

}  // namespace world_files_test
}  // namespace synthetic_dataset::run
