#include "programs/console/script_reporter.h"

#include <gtest/gtest.h>

namespace synthetic_dataset::programs {
namespace {

TEST(ProgressValue, HasTheRateAndWhatItLeavesOfTheTime) {
  EXPECT_EQ(Value(Value::Map{{"scenes_done", Value(5)},
                             {"scenes", Value(20)},
                             {"rate", Value(2.5)},
                             {"time_left", Value(6.0)},
                             {"warnings", Value(1)}}),
            progressValue(5, 20, 2.0, 1));
}

TEST(ProgressValue, SaysNothingOfTheTimeBeforeTheFirstScene) {
  const Value value = progressValue(0, 20, 0.0, 0);
  EXPECT_EQ(Value(0.0), value.as<Value::Map>()->at("rate"));
  EXPECT_EQ(Value(0.0), value.as<Value::Map>()->at("time_left"));
}

}  // namespace
}  // namespace synthetic_dataset::programs
