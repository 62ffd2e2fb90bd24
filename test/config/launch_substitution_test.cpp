#include "config/launch_substitution.h"

#include <string>

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::config {
namespace launch_substitution_test {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::optional<std::string> packageFolder(const std::string& name) {
  if (name == "hall") return "/ros/hall";
  return std::nullopt;
}

std::optional<std::string> variable(const std::string& name) {
  if (name == "USER") return "ann";
  if (name == "DATA") return "$(find hall)/data of $(env USER)";
  return std::nullopt;
}

std::string filledIn(const std::string& text) {
  return substitute(text, {"/home/ann/my.yaml", packageFolder, variable});
}

TEST(Substitute, LeavesPlainTextAlone) {
  for (const std::string text : {"", "a: 1", "price: $5 (net)", "$()", "$", "a: $(find hall"}) {
    EXPECT_EQ(filledIn(text), text);
  }
}

TEST(Substitute, FillsInTheEnvironment) {
  EXPECT_EQ(filledIn("a: /home/$(env USER)/$( env  USER )"), "a: /home/ann/ann");
  EXPECT_EQ(filledIn("$$(env USER)"), "$ann");
}

TEST(Substitute, FillsInDefaultsOfWhatIsNotSet) {
  EXPECT_EQ(filledIn("$(optenv USER bob)"), "ann");
  EXPECT_EQ(filledIn("$(optenv NOBODY bob  and eve)"), "bob and eve");
  EXPECT_EQ(filledIn("[$(optenv NOBODY)]"), "[]");
}

TEST(Substitute, FillsInTheFolderOfTheFile) {
  EXPECT_EQ(filledIn("$(dirname)/x.bag"), "/home/ann/x.bag");
}

TEST(Substitute, FillsInPackages) {
  EXPECT_EQ(filledIn("a: $(find hall)/w.sdf b"), "a: /ros/hall/w.sdf b");
  EXPECT_EQ(filledIn("a: $(find hall) b"), "a: /ros/hall b");
}

// As roslaunch does: whatever follows up to the next space counts as a path.
TEST(Substitute, PutsASlashBehindAPackage) {
  EXPECT_EQ(filledIn("a: '$(find hall)'"), "a: '/ros/hall/'");
  EXPECT_EQ(filledIn("a: $(find hall)\\w.sdf"), "a: /ros/hall/w.sdf");
}

TEST(Substitute, FillsInPackagesThatTheEnvironmentNames) {
  EXPECT_EQ(filledIn("$(env DATA)"), "/ros/hall/data of $(env USER)");
}

TEST(Substitute, FillsInCommentsToo) {
  EXPECT_THAT(test::messagesOf([] { return filledIn("# $(find nowhere)\na: 1"); }),
              testing::ElementsAre(HasSubstr("/home/ann/my.yaml: line 1: found $(find nowhere)")));
}

TEST(Substitute, NamesLineAndWhatIsKnown) {
  for (const std::string wrong : {"$(arg rate)", "$(anon x)", "$(eval 1 + 1)", "$(finde hall)"}) {
    EXPECT_THAT(test::messagesOf([&] { return filledIn("a: $(env USER)\n\nb: " + wrong); }),
                testing::ElementsAre(
                    AllOf(HasSubstr("/home/ann/my.yaml: line 3: found " + wrong),
                          HasSubstr("$(find PKG), $(env NAME), $(optenv NAME [DEFAULT])"))))
        << wrong;
  }
}

TEST(Substitute, RefusesWrongCountsOfWords) {
  for (const std::string wrong :
       {"$(find)", "$(find a b)", "$(env)", "$(env a b)", "$(optenv)", "$( )"}) {
    EXPECT_THAT(test::messagesOf([&] { return filledIn(wrong); }),
                testing::ElementsAre(HasSubstr("line 1: found " + wrong)))
        << wrong;
  }
}

TEST(Substitute, RefusesAVariableThatIsNotSet) {
  EXPECT_THAT(test::messagesOf([] { return filledIn("$(env NOBODY)"); }),
              testing::ElementsAre(HasSubstr("variable NOBODY is not set")));
}

TEST(Substitute, NamesTheLineWhereAParenthesisIsMissing) {
  EXPECT_THAT(
      test::messagesOf([] { return filledIn("a: 1\nb: $(find hall/x\nc: $(env USER)"); }),
      testing::ElementsAre(HasSubstr("line 2: found '$(find hall/x', in which another '$'")));
}

}  // namespace launch_substitution_test
}  // namespace synthetic_dataset::config
