#include "output/progress.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace synthetic_dataset::output {
namespace progress_test {

using testing::ElementsAre;
using testing::EndsWith;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

class ProgressTest : public testing::Test {
 protected:
  Progress make(std::int64_t scene_count, Progress::Display display) {
    return Progress(
        scene_count, display, [this] { return now_; },
        [this](const std::string& text) { shown_.push_back(text); });
  }

  double now_ = 1000.0;  // [s]
  std::vector<std::string> shown_;
};

TEST_F(ProgressTest, ShowsPercentRateAndTimeLeft) {
  Progress progress = make(200, Progress::Display::kLog);
  now_ += 0.5;
  progress.sceneDone();
  EXPECT_THAT(shown_, ElementsAre("scene 1 of 200 (0 %), 2.0 scenes/s, 1:40 left"));
}

TEST_F(ProgressTest, LogsTheFirstAndTheLastSceneAndFewBetween) {
  Progress progress = make(101, Progress::Display::kLog);
  for (int scene = 0; scene < 101; ++scene) {
    now_ += 0.125;
    progress.sceneDone();
  }
  EXPECT_THAT(shown_, ElementsAre("scene 1 of 101 (0 %), 8.0 scenes/s, 0:13 left",
                                  "scene 41 of 101 (40 %), 8.0 scenes/s, 0:08 left",
                                  "scene 81 of 101 (80 %), 8.0 scenes/s, 0:03 left",
                                  "scene 101 of 101 (100 %), 8.0 scenes/s"));
}

TEST_F(ProgressTest, RewritesOneLineOfATerminal) {
  Progress progress = make(3, Progress::Display::kTerminal);
  for (int scene = 0; scene < 3; ++scene) {
    now_ += 1000.0;
    progress.sceneDone();
  }
  ASSERT_THAT(shown_, SizeIs(3));
  EXPECT_THAT(shown_, testing::Each(StartsWith("\r")));
  EXPECT_THAT(shown_[1], Not(EndsWith("\n")));
  EXPECT_THAT(shown_[2], EndsWith("\n"));
}

TEST_F(ProgressTest, CoversWhatALongerLineLeftOnTheTerminal) {
  Progress progress = make(2, Progress::Display::kTerminal);
  now_ += 1.0;
  progress.sceneDone();
  now_ += 1.0;
  progress.sceneDone();
  EXPECT_EQ(shown_[0], "\rscene 1 of 2 (50 %), 1.0 scenes/s, 0:01 left");
  EXPECT_THAT(shown_[1], StartsWith("\rscene 2 of 2 (100 %), 1.0 scenes/s  "));
  EXPECT_EQ(shown_[1].size(), shown_[0].size() + 1);  // and the newline
}

TEST_F(ProgressTest, WritesHoursWhenItTakesHours) {
  Progress progress = make(5, Progress::Display::kLog);
  now_ += 3600.0 + 2 * 60.0 + 3.0;
  progress.sceneDone();
  EXPECT_THAT(shown_, ElementsAre("scene 1 of 5 (20 %), 0.0 scenes/s, 4:08:12 left"));
}

TEST_F(ProgressTest, ClaimsNoRateBeforeTheClockMoves) {
  Progress progress = make(4, Progress::Display::kLog);
  progress.sceneDone();
  EXPECT_THAT(shown_, ElementsAre("scene 1 of 4 (25 %)"));
}

TEST_F(ProgressTest, ShowsTheOnlySceneOnce) {
  Progress progress = make(1, Progress::Display::kLog);
  now_ += 1.0;
  progress.sceneDone();
  EXPECT_THAT(shown_, ElementsAre("scene 1 of 1 (100 %), 1.0 scenes/s"));
}

}  // namespace progress_test
}  // namespace synthetic_dataset::output
