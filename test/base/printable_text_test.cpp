#include "base/printable_text.h"

#include <gtest/gtest.h>

namespace synthetic_dataset::base {
namespace printable_text_test {

TEST(PrintableText, KeepsUtf8AsItIs) {
  const std::string text = "größe, Ω, 猫, 🐈 and tabs\t\n";
  EXPECT_EQ(printable(text), text);
}

TEST(PrintableText, EscapesBytesThatAreNoUtf8) {
  EXPECT_EQ(printable("gr\xf6\xdf"
                      "e"),
            R"(gr\xf6\xdfe)");                                      // Latin 1
  EXPECT_EQ(printable("cut \xe2\x82"), R"(cut \xe2\x82)");          // the euro's first two bytes
  EXPECT_EQ(printable("\xc0\xaf"), R"(\xc0\xaf)");                  // an overlong slash
  EXPECT_EQ(printable("\xed\xa0\x80"), R"(\xed\xa0\x80)");          // half of a surrogate pair
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), R"(\xf4\x90\x80\x80)");  // past the last character
}

TEST(PrintableText, HasNoCommandsForTerminals) {
  EXPECT_EQ(printable("plumb\x1b]0;title\a\x1b[2J\r_bob\x7f"),
            R"(plumb\x1b]0;title\x07\x1b[2J\x0d_bob\x7f)");
  EXPECT_EQ(printable("\xc2\x9b"
                      "2J\xc2\xa0"),
            "\\xc2\\x9b"
            "2J\xc2\xa0");  // as one character
  EXPECT_EQ(asUtf8("\x1b\r\n\xf6"), "\x1b\r\n\\xf6");
}

}  // namespace printable_text_test
}  // namespace synthetic_dataset::base
