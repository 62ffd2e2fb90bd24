#include "synthetic_dataset/required.h"

#include <gmock/gmock.h>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset {
namespace required_test {

using testing::AllOf;
using testing::HasSubstr;

std::string failureOf(const Required<double>& value) {
  try {
    (void)value();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Required, NamesWhatWasNotComputedAndWhatAsksForIt) {
  EXPECT_THAT(failureOf(SceneObject().truncation),
              AllOf(HasSubstr("SceneObject::truncation"), HasSubstr("Requirements::visibility")));
}

TEST(Required, HoldsWhatWasComputed) {
  SceneObject object;
  EXPECT_FALSE(object.visibility.isKnown());
  object.visibility = 0.0;
  EXPECT_TRUE(object.visibility.isKnown());
  EXPECT_EQ(object.visibility(), 0.0);
}

TEST(Required, KnowsNothingFromNotKnown) {
  SceneObject object;
  EXPECT_THROW((void)object.visible_box(), Error);
  object.visible_box = std::nullopt;
  EXPECT_FALSE(object.visible_box().has_value());
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
