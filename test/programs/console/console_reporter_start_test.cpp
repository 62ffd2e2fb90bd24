#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "programs/console/console_reporter.h"

namespace synthetic_dataset::programs {
namespace start_report_test {

using testing::ElementsAre;
using testing::IsEmpty;

class StartReportTest : public testing::Test {
 protected:
  /// Calls look() at this time.
  void lookAt(double time) {
    now_ = time;
    report_.look();
  }

  double now_ = 100.0;
  std::vector<std::string> said_;
  StartReport report_{[this] { return now_; },
                      [this](const std::string& message) { said_.push_back(message); }};
};

TEST_F(StartReportTest, OfAQuickStartIsNothing) {
  report_.begin("reading 'a.world'");
  lookAt(101.9);
  EXPECT_THAT(said_, IsEmpty());
}

TEST_F(StartReportTest, NamesTheStageThatGoesOnAfterTwoSeconds) {
  report_.begin("reading 'a.world'");
  lookAt(101.0);
  report_.begin("reading the meshes");
  lookAt(102.1);
  EXPECT_THAT(said_, ElementsAre("still starting after 2 s: reading the meshes"));
}

TEST_F(StartReportTest, NamesEachStageOnce) {
  report_.begin("reading the meshes");
  lookAt(102.1);
  lookAt(104.2);
  report_.begin("decoding the pictures");
  lookAt(107.0);
  report_.begin("reading the meshes");
  lookAt(110.0);
  EXPECT_THAT(said_, ElementsAre("still starting after 2 s: reading the meshes",
                                 "still starting after 7 s: decoding the pictures"));
}

TEST_F(StartReportTest, PassesOverStagesThatFollowQuickly) {
  report_.begin("reading 'a.sdf'");
  lookAt(102.0);
  for (const char* file : {"reading 'b.sdf'", "reading 'c.sdf'", "reading 'd.sdf'"}) {
    report_.begin(file);
    lookAt(now_ + 0.7);
  }
  EXPECT_THAT(said_, ElementsAre("still starting after 2 s: reading 'a.sdf'",
                                 "still starting after 4 s: reading 'd.sdf'"));
}

TEST_F(StartReportTest, SaysNothingBeforeAStageHasBegun) {
  lookAt(110.0);
  EXPECT_THAT(said_, IsEmpty());
}

}  // namespace start_report_test
}  // namespace synthetic_dataset::programs
