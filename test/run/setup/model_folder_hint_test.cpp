#include "run/setup/model_folder_hint.h"

#include <gmock/gmock.h>

#include "support/temporary_folder.h"

namespace synthetic_dataset::run {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class ModelFolderHint : public ::testing::Test {
 protected:
  void makeModel(const std::string& name) const {
    folder_.write(name + "/model.config", "<model/>");
  }

  [[nodiscard]] std::string hint() const {
    return modelFolderHint(folder_.path() / "my_package/worlds/hall.world",
                           {"model://shelf", "model://crate/model.config", "package://lamp",
                            "model://../my_package", "shelf.png", "file:///tmp/x.dae"});
  }

  [[nodiscard]] std::string inFolder(const std::string& name) const {
    return "world/model_folders: '" + (folder_ / name).string() + "' has ";
  }

  test::TemporaryFolder folder_;
};

TEST_F(ModelFolderHint, IsOfTheFolderWithMostOfTheMissingModels) {
  makeModel("my_package/worlds/lamp");
  makeModel("my_package/models/shelf");
  makeModel("my_package/models/crate");
  EXPECT_EQ(hint(), inFolder("my_package/models") +
                        "2 of the missing models and files; it should be listed here, or in "
                        "GAZEBO_MODEL_PATH");
}

TEST_F(ModelFolderHint, FindsThoseOfAPackageNearby) {
  makeModel("gazebo_things/models/lamp");
  EXPECT_THAT(hint(),
              StartsWith(inFolder("gazebo_things/models") + "one of the missing models and files"));
}

TEST_F(ModelFolderHint, PrefersTheNearestFolder) {
  makeModel("models/lamp");
  makeModel("my_package/worlds/models/lamp");
  EXPECT_THAT(hint(), HasSubstr("my_package/worlds/models'"));
}

TEST_F(ModelFolderHint, IsEmptyWhereNoFolderHasAny) {
  makeModel("my_package/models/table");
  folder_.write("my_package/models/crate/notes.txt", "without what is missing of it");
  EXPECT_THAT(hint(), IsEmpty());
}

}  // namespace
}  // namespace synthetic_dataset::run
