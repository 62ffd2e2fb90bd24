#include "run/work_plan.h"

#include <gmock/gmock.h>

namespace synthetic_dataset {
namespace {

bool nothingIsThere(std::int64_t /*scene*/) { return false; }

TEST(WorkPlan, OfAFreshRunIsAllOfIt) {
  const WorkPlan plan(5, 2, {}, {}, nothingIsThere);
  EXPECT_EQ(plan.sceneCount(), 10);
  EXPECT_EQ(plan.missingCount(), 10);
  EXPECT_TRUE(plan.wants(0));
  EXPECT_EQ(plan.endOfWork(5), 5);
  EXPECT_EQ(plan.endOfWork(3), 3);
}

TEST(WorkPlan, LeavesOutInstantsOfWhichAllScenesAreThere) {
  const WorkPlan plan(3, 2, {}, {}, [](std::int64_t scene) { return scene != 3; });
  EXPECT_FALSE(plan.wants(0));
  EXPECT_TRUE(plan.wants(1));
  EXPECT_FALSE(plan.wants(2));
  EXPECT_EQ(plan.missingCount(), 1);
  EXPECT_EQ(plan.endOfWork(3), 2);
  EXPECT_EQ(plan.endOfWork(1), 0);
}

TEST(WorkPlan, OfACompleteRunIsEmpty) {
  const WorkPlan plan(3, 1, {}, {}, [](std::int64_t /*scene*/) { return true; });
  EXPECT_EQ(plan.missingCount(), 0);
  EXPECT_EQ(plan.endOfWork(3), 0);
}

TEST(WorkPlan, MakesOnlyTheScenesThatAreAskedFor) {
  const WorkPlan plan(5, 2, {}, {1, 3}, [](std::int64_t scene) { return scene == 2; });
  EXPECT_EQ(plan.sceneCount(), 4);
  EXPECT_EQ(plan.missingCount(), 3);
  EXPECT_FALSE(plan.wants(0));
  EXPECT_TRUE(plan.wants(1));
  EXPECT_FALSE(plan.wants(2));
  EXPECT_TRUE(plan.wants(3));
  EXPECT_EQ(plan.endOfWork(5), 4);
  EXPECT_EQ(plan.endOfWork(3), 2);
}

}  // namespace
}  // namespace synthetic_dataset
