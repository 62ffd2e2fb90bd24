#include "run/run_summary.h"

#include <gmock/gmock.h>

namespace synthetic_dataset::run {
namespace run_summary_test {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

RunSummary ofScenes(std::int64_t scenes) {
  RunSummary summary;
  summary.scenes = summary.planned_scenes = summary.dataset_scenes = scenes;
  summary.seconds = 4.0;
  summary.times = {0.52, 3.9, 2.04, 1.0, 0.26};
  return summary;
}

TEST(RunSummary, SaysHowLongEachStageWorked) {
  EXPECT_THAT(summaryLines(ofScenes(8)),
              AllOf(Contains(HasSubstr("8 of 8 scenes in 4.0 s (2.0 scenes/s)")),
                    Contains("time: set-up 0.5 s; side by side drawing 3.9 s, labels 2.0 s, "
                             "writing 1.0 s; files of the whole dataset 0.3 s")));
}

TEST(RunSummary, HasNoTimesOfScenesThatItDidNotMake) {
  EXPECT_THAT(summaryLines(ofScenes(0)), Each(Not(HasSubstr("time:"))));
}

}  // namespace run_summary_test
}  // namespace synthetic_dataset::run
