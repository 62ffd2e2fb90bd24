#include "synthetic_dataset/required.h"

#include <gmock/gmock.h>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset {
namespace required_test {

using testing::AllOf;
using testing::HasSubstr;

std::string truncationOf(const SceneObject& object) {
  try {
    (void)object.truncation();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Required, NamesWhatWasNotComputedAndWhatAsksForIt) {
  EXPECT_THAT(truncationOf(SceneObject()),
              AllOf(HasSubstr("PixelCounts::silhouette"), HasSubstr("Requirements::visibility")));
}

TEST(Required, HoldsWhatWasComputed) {
  SceneObject object;
  EXPECT_FALSE(object.pixels.visible.isKnown());
  object.pixels.visible = 0;
  EXPECT_TRUE(object.pixels.visible.isKnown());
  EXPECT_EQ(object.pixels.visible(), 0);
}

TEST(Required, KnowsNothingFromNotKnown) {
  SceneObject object;
  EXPECT_THROW((void)object.silhouette_box(), Error);
  object.silhouette_box = std::nullopt;
  EXPECT_FALSE(object.silhouette_box().has_value());
}

TEST(SceneObject, AsksForPixelsWhenAskedForALabel) {
  SceneObject object;
  EXPECT_THROW((void)object.labelled(), Error);
  object.pixels.visible = 1;
  EXPECT_TRUE(object.labelled());
  object.dropped = true;
  EXPECT_FALSE(object.labelled());
}

}  // namespace required_test
}  // namespace synthetic_dataset
