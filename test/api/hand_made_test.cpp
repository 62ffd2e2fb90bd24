#include "synthetic_dataset/hand_made.h"

#include <gmock/gmock.h>

namespace synthetic_dataset {
namespace hand_made_test {

using testing::ElementsAre;

const cv::Rect kPixels(10, 20, 30, 40);

TEST(HandMadeObject, HasMeasuresThatAgree) {
  const SceneObject cup = handMadeObject("cup", kPixels);
  EXPECT_TRUE(cup.labelled());
  EXPECT_EQ(cup.silhouette().bounds(), kPixels);
  EXPECT_EQ(cup.visible_mask().count(), kPixels.area());
  EXPECT_EQ(cup.pixels.visible(), kPixels.area());
  EXPECT_EQ(cup.visibleBox()->left, 9.5);
  EXPECT_EQ(cup.visibleBox()->bottom, 59.5);
  EXPECT_EQ(cup.visibility(), 1.0);
  EXPECT_EQ(cup.truncation(), 0.0);
}

TEST(HandMadeObject, IsTruncatedAtTheImagesEdge) {
  const SceneObject cup = handMadeObject("cup", {620, 0, 40, 10});
  EXPECT_EQ(cup.pixels.silhouette(), 400);
  EXPECT_EQ(cup.pixels.visible(), 200);
  EXPECT_EQ(cup.visibility(), 0.5);
  EXPECT_EQ(cup.truncation(), 0.5);
  EXPECT_EQ(cup.visibleBox()->right, 639.5);
  EXPECT_EQ(cup.silhouette_box()->right, 659.5);
}

TEST(HandMadeObject, MayBeHidden) {
  const SceneObject cup = hidden(handMadeObject("cup", kPixels));
  EXPECT_FALSE(cup.labelled());
  EXPECT_EQ(cup.silhouette().count(), kPixels.area());
  EXPECT_EQ(cup.visibleBox(), std::nullopt);
}

TEST(HandMadeScene, ShowsItsObjectsInItsMaps) {
  const Scene scene =
      handMadeScene(7, {handMadeObject("cup", kPixels), handMadeObject("lid", {35, 20, 10, 10})});
  EXPECT_EQ(scene.name, "00000007");
  EXPECT_EQ(scene.instance_map().at<std::uint16_t>(20, 10), 1);
  EXPECT_EQ(scene.instance_map().at<std::uint16_t>(20, 35), 2);
  EXPECT_EQ(scene.class_map().at<std::uint16_t>(20, 10), 1);
  EXPECT_EQ(scene.instance_map().at<std::uint16_t>(0, 0), 0);
  EXPECT_EQ(scene.depth().at<float>(20, 10), 10.0F);
  EXPECT_EQ(scene.depth().at<float>(0, 0), 0.0F);
}

TEST(HandMadeDataset, HasEachClassOnceInTheOrderOfTheirNumbers) {
  SceneObject cup = handMadeObject("cup"), lid = handMadeObject("lid"), jar = handMadeObject("jar");
  cup.class_id = jar.class_id = 5;
  lid.class_id = 2;
  jar.class_name = cup.class_name;
  const DatasetInfo dataset = handMadeDataset({cup, lid, jar});
  EXPECT_EQ(dataset.objects.size(), 3U);
  EXPECT_THAT(dataset.classNamesWithoutGaps(), ElementsAre("unused_0", "unused_1", "lid_class",
                                                           "unused_3", "unused_4", "cup_class"));
  EXPECT_EQ(dataset.cameras.size(), 1U);
}

}  // namespace hand_made_test
}  // namespace synthetic_dataset
