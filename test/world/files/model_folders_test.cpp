#include "world/files/model_folders.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/error_messages.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {
namespace model_folders_test {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A shelf and a cart in a shop, a box beside it.
class ModelFolders : public ::testing::Test {
 protected:
  ModelFolders() {
    folder.write("shop/shelf/model.config", "");
    folder.write("shop/shelf/model.sdf", "");
    folder.write("box/model.config", "");
    folder.write("shop/cart.urdf", "");
    folder.write("shop/price.txt", "");
  }

  test::TemporaryFolder folder;
};

TEST_F(ModelFolders, AreFoundInSubfoldersSorted) {
  EXPECT_THAT(findModels(folder.path()),
              ElementsAre(folder / "box", folder / "shop/cart.urdf", folder / "shop/shelf"));
}

TEST_F(ModelFolders, ThatAreLinksAreFollowedOnce) {
  const test::TemporaryFolder links;
  std::filesystem::create_directory_symlink(folder / "box", links / "crate");
  std::filesystem::create_directory_symlink(links.path(), links / "crate_circle");
  EXPECT_THAT(findModels(links.path()), ElementsAre(links / "crate"));
}

TEST_F(ModelFolders, AreToldWhereTheyAreMissing) {
  EXPECT_THAT(test::messagesOf([] { (void)findModels("/nowhere/models"); }),
              testing::ElementsAre(HasSubstr("/nowhere/models: no such folder")));
}

TEST_F(ModelFolders, StandForAllModelsInThem) {
  const std::string shop = folder / "shop";
  EXPECT_THAT(modelsAt(shop), ElementsAre(shop + "/cart.urdf", shop + "/shelf"));
}

TEST_F(ModelFolders, ThatAreModelsStandForThemselvesAsDoFilesAndUris) {
  for (const std::string& model : {(folder / "box").string(), (folder / "shop/cart.urdf").string(),
                                   std::string("model://box"), std::string("/nowhere/a.sdf")}) {
    EXPECT_THAT(modelsAt(model), ElementsAre(model));
  }
}

TEST_F(ModelFolders, WithoutModelsAreTold) {
  folder.write("empty/readme.txt", "");
  EXPECT_THAT(test::messagesOf([&] { (void)modelsAt(folder / "empty"); }),
              testing::ElementsAre(AllOf(HasSubstr("/empty', a folder that is not a model"),
                                         HasSubstr("hold folders with a model.config"))));
}

}  // namespace model_folders_test
}  // namespace synthetic_dataset::world
