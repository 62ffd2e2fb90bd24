#include "programs/setup_assistant/service/label_filter.h"

#include <map>
#include <string>

#include <gtest/gtest.h>

namespace synthetic_dataset::programs {
namespace {

using output::WrittenLabel;

LabelFilter filterOf(const std::map<std::string, std::string>& query) {
  HttpRequest request;
  for (const auto& [name, value] : query) request.query[name] = value;
  return LabelFilter(request);
}

TEST(LabelFilter, KnowsSizesAsCocoDoes) {
  EXPECT_EQ("small", sizeOf({0, "a", 1023, 1.0}));
  EXPECT_EQ("medium", sizeOf({0, "a", 1024, 1.0}));
  EXPECT_EQ("medium", sizeOf({0, "a", 9215, 1.0}));
  EXPECT_EQ("large", sizeOf({0, "a", 9216, 1.0}));
  EXPECT_EQ("", sizeOf({0, "a", {}, 1.0}));
}

TEST(LabelFilter, KnowsHowMuchIsHidden) {
  EXPECT_EQ("none", occlusionOf({0, "a", 10, 1.0}));
  EXPECT_EQ("part", occlusionOf({0, "a", 10, 0.5}));
  EXPECT_EQ("most", occlusionOf({0, "a", 10, 0.49}));
  EXPECT_EQ("", occlusionOf({0, "a", 10, {}}));
}

TEST(LabelFilter, TakesWhatMeetsAllThatIsAskedFor) {
  const LabelFilter filter = filterOf({{"class", "rover"}, {"size", "small"}, {"split", "val"}});
  EXPECT_TRUE(filter.isOfLabels());
  EXPECT_TRUE(filter.takes({0, "rover", 5, 0.1}));
  EXPECT_FALSE(filter.takes({0, "drone", 5, 0.1}));
  EXPECT_FALSE(filter.takes({0, "rover", 5000, 0.1}));
  EXPECT_TRUE(filter.takesSplit("val"));
  EXPECT_FALSE(filter.takesSplit("train"));
}

TEST(LabelFilter, TakesEverythingWhereNothingIsAskedFor) {
  const LabelFilter filter = filterOf({{"class", ""}});
  EXPECT_FALSE(filter.isOfLabels());
  EXPECT_TRUE(filter.takes({0, "rover", {}, {}}));
  EXPECT_TRUE(filter.takesSplit(""));
}

}  // namespace
}  // namespace synthetic_dataset::programs
