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

TEST(RunSummary, IsForPrograms) {
  RunSummary summary = ofScenes(8);
  summary.manifest = "/data/manifest.sqlite";
  summary.warnings = {{"dark", 3}};
  summary.objects.push_back({"rover", 8, 7, 0, 8, 7});
  const Value::Map value = summaryValue(summary);
  EXPECT_EQ(*value.at("scenes").as<std::int64_t>(), 8);
  EXPECT_EQ(*value.at("manifest").as<std::string>(), "/data/manifest.sqlite");
  EXPECT_EQ(*value.at("warnings").as<Value::Map>()->at("dark").as<std::int64_t>(), 3);
  const auto& rover = *value.at("objects").as<Value::List>()->front().as<Value::Map>();
  EXPECT_EQ(*rover.at("scenes_labelled").as<std::int64_t>(), 7);
}

}  // namespace run_summary_test
}  // namespace synthetic_dataset::run
