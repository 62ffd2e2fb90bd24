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

TEST(SceneObject, MeasuresByItsPixels) {
  SceneObject object;
  EXPECT_THROW((void)object.visibility(), Error);
  EXPECT_THROW((void)object.visibleBox(), Error);
  object.pixels.silhouette = 200;
  object.pixels.silhouette_in_image = 150;
  object.pixels.visible = 50;
  EXPECT_EQ(object.visibility(), 0.25);
  EXPECT_EQ(object.truncation(), 0.25);
  object.visible_mask = Mask(cv::Mat1b(5, 10, 255), {20, 30}, {64, 48});
  ASSERT_TRUE(object.visibleBox());
  EXPECT_EQ(object.visibleBox()->left, 19.5);
  EXPECT_EQ(object.visibleBox()->top, 29.5);
  EXPECT_EQ(object.visibleBox()->right, 29.5);
  EXPECT_EQ(object.visibleBox()->bottom, 34.5);
}

TEST(SceneObject, MeasuresNothingOfNoPixel) {
  SceneObject object;
  object.pixels.silhouette = object.pixels.silhouette_in_image = object.pixels.visible = 0;
  EXPECT_EQ(object.visibility(), 0.0);
  EXPECT_EQ(object.truncation(), 0.0);
  object.visible_mask = Mask(cv::Size(64, 48));
  EXPECT_EQ(object.visibleBox(), std::nullopt);
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
