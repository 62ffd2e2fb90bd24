#include "programs/setup_assistant/run/run_log.h"

#include <string>

#include <gtest/gtest.h>

namespace synthetic_dataset::programs {
namespace {

TEST(RunLog, KnowsHowFarARunIs) {
  RunLog log;
  log.take("\033[0m[ INFO] [1.5]: 10 scenes\033[0m");
  log.take(R"({"rate": 2.5, "scenes": 10, "scenes_done": 4, "time_left": 2.4, "warnings": 0})");
  EXPECT_EQ(4, log.scenes_done);
  EXPECT_EQ(10, log.scenes);
  EXPECT_EQ(2.5, log.rate);
  EXPECT_EQ(2.4, log.time_left);
  ASSERT_EQ(1U, log.lines.size());
  EXPECT_EQ("[ INFO] [1.5]: 10 scenes", log.lines.front());
}

TEST(RunLog, HasTheErrorsOfTheLastLine) {
  RunLog log;
  log.take(R"({"errors": ["world: no such file", "camera: none"], "result": "failed"})");
  EXPECT_EQ("failed", log.result);
  ASSERT_EQ(2U, log.errors.size());
  EXPECT_EQ("world: no such file", log.errors.front());
}

TEST(RunLog, KeepsTheLastLinesAlone) {
  RunLog log;
  for (int i = 0; i < 1000; ++i) log.take("line " + std::to_string(i));
  log.take("{ not JSON");
  EXPECT_EQ(300U, log.lines.size());
  EXPECT_EQ("{ not JSON", log.lines.back());
}

}  // namespace
}  // namespace synthetic_dataset::programs
