#include "synthetic_dataset/label_text.h"

#include <gtest/gtest.h>

namespace synthetic_dataset {
namespace {

TEST(LabelText, FixedHasSoManyDecimalsWhateverTheSize) {
  EXPECT_EQ(fixed(2.5, 5), "2.50000");
  EXPECT_EQ(fixed(-0.0, 5), "-0.00000");
  EXPECT_EQ(fixed(0.000004, 5), "0.00000");
  EXPECT_EQ(fixed(1e20, 1), "100000000000000000000.0");
}

TEST(LabelText, FixedRoundsTheExactBinaryValueAsPrintfDoes) {
  EXPECT_EQ(fixed(0.125, 2), "0.12");
  EXPECT_EQ(fixed(0.375, 2), "0.38");
}

TEST(LabelText, SceneNumbersHaveEightDigits) {
  EXPECT_EQ(sceneNumber(0), "00000000");
  EXPECT_EQ(sceneNumber(1234), "00001234");
  EXPECT_EQ(sceneNumber(123456789), "123456789");
}

}  // namespace
}  // namespace synthetic_dataset
