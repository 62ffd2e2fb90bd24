#include "synthetic_dataset/label_text.h"

#include <gtest/gtest.h>

namespace synthetic_dataset {
namespace label_text_test {

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

TEST(LabelText, SafeFileNamesKeepWhatAFileNameCanHold) {
  EXPECT_EQ(safeFileName("rover_1"), "rover_1");
  EXPECT_EQ(safeFileName("v1.2-b"), "v1.2-b");
  EXPECT_EQ(safeFileName("Fräse"), "Fräse");
}

TEST(LabelText, SafeFileNamesStayInTheirFolder) {
  for (const std::string text : {"..", "a/b", "../x", "a\nb", "", ".", "a b", "'\"", "a:b"}) {
    const std::string name = safeFileName(text);
    EXPECT_EQ(name.find_first_of("/\n '\":"), std::string::npos) << text;
    EXPECT_NE(name.front(), '.') << text;
  }
}

TEST(LabelText, SafeFileNamesOfDifferentTextsDiffer) {
  EXPECT_NE(safeFileName("a/b"), safeFileName("a b"));
  EXPECT_NE(safeFileName("a/b"), safeFileName("a_b"));
  EXPECT_NE(safeFileName(std::string(300, 'x') + "1"), safeFileName(std::string(300, 'x') + "2"));
}

TEST(LabelText, SafeFileNamesAreShortAndWholeUtf8) {
  std::string text = "x";
  for (int i = 0; i < 150; ++i) text += "ä";  // 301 bytes
  const std::string name = safeFileName(text);
  EXPECT_LE(name.size(), 100U);
  EXPECT_EQ((name.size() - std::string("x_00000000").size()) % 2, 0U);
}

}  // namespace label_text_test
}  // namespace synthetic_dataset
