#include "synthetic_dataset/nearest_name.h"

#include <gtest/gtest.h>

namespace synthetic_dataset {
namespace nearest_name_test {

TEST(NearestName, FindsWhatATypingMistakeMeant) {
  EXPECT_EQ(nearestName("simulated_rte", {"bag_file", "simulated_rate"}), "simulated_rate");
  EXPECT_EQ(nearestName("alpha/base_lnik", {"alpha/base_link", "alpha/base_laser"}),
            "alpha/base_link");
  EXPECT_EQ(nearestName("ligth", {"glass", "light"}), "light") << "letters that are swapped";
}

TEST(NearestName, FindsNothingWhereNothingIsNear) {
  EXPECT_FALSE(nearestName("camera", {"bag_file", "world"}));
  EXPECT_FALSE(nearestName("x", {}));
}

TEST(NearestName, AsksTheQuestion) {
  EXPECT_EQ(didYouMean("wrld", {"world"}), "; did you mean 'world'?");
  EXPECT_EQ(didYouMean("zebra", {"world"}), "");
}

}  // namespace nearest_name_test
}  // namespace synthetic_dataset
