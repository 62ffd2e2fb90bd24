#include "synthetic_dataset/box_choice.h"

#include <gmock/gmock.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset {
namespace box_choice_test {

BoxChoice choiceIn(const Value::Map& settings) {
  Parameters parameters{settings};
  return readBoxChoice(parameters);
}

TEST(BoxChoice, IsTheVisibleBoxUnlessTheUserWantsAnother) {
  EXPECT_EQ(choiceIn({}), BoxChoice::kVisible);
  EXPECT_EQ(choiceIn({{"box", Value("silhouette")}}), BoxChoice::kSilhouette);
  EXPECT_EQ(choiceIn({{"box", Value("loose")}}), BoxChoice::kLoose);
}

TEST(BoxChoice, NamesWhatItMayBe) {
  Parameters parameters(Value::Map{{"box", Value("lose")}}, "coco");
  (void)readBoxChoice(parameters);
  EXPECT_THAT(parameters.errors(),
              testing::ElementsAre("coco/box: found 'lose'; it should be visible, silhouette or "
                                   "loose; did you mean 'loose'?"));
}

TEST(BoxChoice, AsksForWhatItNeeds) {
  const CameraModel camera(100, 80, {50, 50, 50, 40}, 0.1, 10);
  SceneObject object;
  EXPECT_THROW((void)boxOf(object, BoxChoice::kVisible, camera), Error);
  EXPECT_THROW((void)boxOf(object, BoxChoice::kSilhouette, camera), Error);
  EXPECT_FALSE(boxOf(object, BoxChoice::kLoose, camera).has_value());
  EXPECT_FALSE(requirementsOf(BoxChoice::kVisible).visibility);
  EXPECT_TRUE(requirementsOf(BoxChoice::kSilhouette).visibility);
}

TEST(BoxChoice, CutsBoxesToTheImage) {
  const CameraModel camera(100, 80, {50, 50, 50, 40}, 0.1, 10);
  SceneObject object;
  object.silhouette_box = Box{-20.5, 10.5, 30.5, 20.5};
  const auto box = boxOf(object, BoxChoice::kSilhouette, camera);
  ASSERT_TRUE(box.has_value());
  EXPECT_EQ(box->left, -0.5);
  EXPECT_EQ(box->right, 30.5);
  object.silhouette_box = Box{-20.5, 10.5, -0.5, 20.5};
  EXPECT_FALSE(boxOf(object, BoxChoice::kSilhouette, camera).has_value());
}

}  // namespace box_choice_test
}  // namespace synthetic_dataset
