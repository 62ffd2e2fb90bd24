#include "run/label_counts.h"

#include <gmock/gmock.h>

#include "run_fixture.h"

namespace synthetic_dataset::run {
namespace label_counts_test {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

TEST(MissingLabels, AreNoneWhereEachObjectHasOne) {
  EXPECT_THAT(missingLabels({{"rover", 1, 0, 0, {}}, {"drone", 40, 40, 39, {}}}, 40), IsEmpty());
}

TEST(MissingLabels, AreToldOfEachObjectWithTheReason) {
  EXPECT_THAT(
      missingLabels({{"rover", 7, 7, 0, {}}, {"drone", 0, 0, 0, {}}, {"cup", 5, 5, 5, {}}}, 40),
      ElementsAre("object drone has a label in none of 40 scenes: it is in view in none of "
                  "them",
                  StartsWith("object cup has a label in none of 40 scenes: too little of it "
                             "is seen in all 5")));
}

TEST(MissingLabels, OfAllAreToldFirst) {
  EXPECT_THAT(missingLabels({{"rover", 0, 0, 0, {}}}, 40),
              ElementsAre(HasSubstr("NOTHING is labelled"), StartsWith("object rover")));
}

TEST(MissingLabels, OfNoSceneAreNone) {
  EXPECT_THAT(missingLabels({{"rover", 0, 0, 0, {}}}, 0), IsEmpty());
}

using LabelCountsTest = test::RunFixture;

TEST_F(LabelCountsTest, AreToldAtTheEndOfARun) {
  struct Listener : Reporter {
    void warning(const std::string& message) override { warnings.push_back(message); }
    std::vector<std::string> warnings;
  } listener;
  parameters["labels"] = Value(Value::Map{{"min_pixels", Value(100000)}});
  generate(listener);
  EXPECT_THAT(listener.warnings,
              testing::IsSupersetOf({HasSubstr("NOTHING is labelled"), HasSubstr("object alpha"),
                                     HasSubstr("object bravo")}));
}

}  // namespace label_counts_test
}  // namespace synthetic_dataset::run
