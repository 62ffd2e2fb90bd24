#include "synthetic_dataset/scene.h"

#include <gtest/gtest.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset {
namespace scene_test {

Scene emptyScene() { return Scene(CameraModel(4, 4, {1, 1, 2, 2}, 0.1, 10)); }

TEST(Scene, HasAFolderForItsSplitAndANameWithoutFolders) {
  Scene scene = emptyScene();
  EXPECT_EQ(scene.splitFolder(), "train");
  scene.split = "val";
  EXPECT_EQ(scene.splitFolder(), "val");
  scene.name = "00000012";
  EXPECT_EQ(scene.flatName(), "00000012");
  scene.name = "front/00000012";
  EXPECT_EQ(scene.flatName(), "front_00000012");
}

TEST(Scene, KnowsTheTransformsThatItWasGiven) {
  Scene scene = emptyScene();
  EXPECT_THROW((void)scene.transform("map", "sensor"), Error);
  scene.setTransforms([](const std::string& target, const std::string& source) {
    Pose X_TS = Pose::Identity();
    X_TS.translation().x() = target == "map" && source == "sensor" ? 1.0 : 2.0;
    return X_TS;
  });
  EXPECT_EQ(scene.transform("map", "sensor").translation().x(), 1.0);
}

}  // namespace scene_test
}  // namespace synthetic_dataset
