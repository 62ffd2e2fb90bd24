#include "run/work_plan.h"

#include <gmock/gmock.h>

namespace synthetic_dataset::run {
namespace work_plan_test {

TEST(WorkPlan, OfAFreshRunIsAllOfIt) {
  const WorkPlan plan(5, 2, [](std::int64_t) { return true; });
  EXPECT_EQ(plan.sceneCount(), 10);
  EXPECT_TRUE(plan.hasInstant(0));
  EXPECT_EQ(plan.endOfWork(5), 5);
  EXPECT_EQ(plan.endOfWork(3), 3);
}

TEST(WorkPlan, LeavesOutInstantsOfWhichNoSceneIsWanted) {
  const WorkPlan plan(3, 2, [](std::int64_t scene) { return scene == 3; });
  EXPECT_FALSE(plan.hasInstant(0));
  EXPECT_TRUE(plan.hasInstant(1));
  EXPECT_FALSE(plan.hasInstant(2));
  EXPECT_FALSE(plan.hasScene(2));
  EXPECT_TRUE(plan.hasScene(3));
  EXPECT_EQ(plan.sceneCount(), 1);
  EXPECT_EQ(plan.endOfWork(3), 2);
  EXPECT_EQ(plan.endOfWork(1), 0);
}

TEST(WorkPlan, OfACompleteRunIsEmpty) {
  const WorkPlan plan(3, 1, [](std::int64_t) { return false; });
  EXPECT_EQ(plan.sceneCount(), 0);
  EXPECT_EQ(plan.endOfWork(3), 0);
}

}  // namespace work_plan_test
}  // namespace synthetic_dataset::run
