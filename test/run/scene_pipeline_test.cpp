#include "run/scene_pipeline.h"

#include <atomic>

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "support/fake_scene_sink.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::run {
namespace scene_pipeline_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

constexpr std::int64_t kSmall = 640 * 480;    // [px]
constexpr std::int64_t kLarge = 3840 * 2160;  // [px]

/// Keeps what is reported.
struct KeepingReporter : Reporter {
  void warning(const std::string& message) override { warnings.push_back(message); }
  void progress(std::int64_t done, std::int64_t all) override { steps.emplace_back(done, all); }

  std::vector<std::string> warnings;
  std::vector<std::pair<std::int64_t, std::int64_t>> steps;
};

/// A scene that is drawn, with warnings of these kinds.
PendingScene pending(std::int64_t index, const std::vector<base::Warning>& warnings = {}) {
  return [index, warnings] {
    FinishedScene finished{Scene(CameraModel(4, 3, {1.0, 1.0, 2.0, 1.5}, 0.05, 100.0)), {}};
    finished.scene.index = index;
    finished.facts.index = index;
    finished.facts.warnings = warnings;
    return finished;
  };
}

PendingScene failing() {
  return []() -> FinishedScene { throw Error("no light"); };
}

class ScenePipelineTest : public testing::Test {
 protected:
  [[nodiscard]] std::vector<std::int64_t> indicesInSink() const {
    std::vector<std::int64_t> indices;
    for (const FinishedScene& each : sink.scenes) indices.push_back(each.scene.index);
    return indices;
  }

  test::FakeSceneSink sink;
  KeepingReporter reporter;
};

TEST_F(ScenePipelineTest, AddsAllScenesInTheirOrder) {
  ScenePipeline pipeline(sink, reporter, 4);
  for (const std::int64_t index : {0, 1, 2, 5}) pipeline.add(pending(index), kSmall);
  pipeline.finish();
  EXPECT_THAT(indicesInSink(), ElementsAre(0, 1, 2, 5));
  EXPECT_EQ(pipeline.addedCount(), 4);
  EXPECT_THAT(reporter.steps,
              ElementsAre(Pair(0, 4), Pair(1, 4), Pair(2, 4), Pair(3, 4), Pair(4, 4)));
}

TEST_F(ScenePipelineTest, MeasuresHowLongScenesTook) {
  ScenePipeline pipeline(sink, reporter, 2);
  for (const std::int64_t index : {0, 1}) pipeline.add(pending(index), kSmall);
  pipeline.finish();
  EXPECT_GT(pipeline.times().labels, 0.0);
  EXPECT_GT(pipeline.times().writing, 0.0);
  EXPECT_GT(pipeline.waited(), 0.0);
}

TEST_F(ScenePipelineTest, HasFinishedALargeSceneBeforeTheNextOneIsDrawn) {
  ScenePipeline pipeline(sink, reporter, 1);
  std::atomic<bool> is_finished = false;
  pipeline.add(
      [&] {
        is_finished = true;
        return pending(0)();
      },
      kLarge);
  EXPECT_TRUE(is_finished);
  pipeline.finish();
  EXPECT_THAT(indicesInSink(), ElementsAre(0));
}

TEST_F(ScenePipelineTest, ReportsEachKindOfWarningOnceWhetherOfTheSceneOrOfTheSink) {
  sink.warnings = {{"a keypoint is behind the camera"}};
  ScenePipeline pipeline(sink, reporter, 2);
  pipeline.add(pending(0, {{"a gap", "at 1 s"}}), kSmall);
  pipeline.add(pending(1, {{"a gap", "at 2 s"}}), kSmall);
  pipeline.finish();
  EXPECT_THAT(reporter.warnings, ElementsAre("a gap (at 1 s)", "a keypoint is behind the camera"));
}

TEST_F(ScenePipelineTest, AddsTheScenesBeforeOneThatCannotBeFinished) {
  ScenePipeline pipeline(sink, reporter, 4);
  pipeline.add(pending(0), kSmall);
  pipeline.add(pending(1), kSmall);
  const auto goOn = [&] {
    pipeline.add(failing(), kSmall);
    pipeline.add(pending(2), kSmall);
    pipeline.finish();
  };
  EXPECT_THAT(test::messagesOf(goOn), testing::ElementsAre(HasSubstr("no light")));
  EXPECT_THAT(indicesInSink(), ElementsAre(0, 1));
}

TEST_F(ScenePipelineTest, ThrowsTheFirstErrorFirst) {
  sink.on_add = [](const FinishedScene& finished) {
    if (finished.scene.index == 1) throw Error("the disk is full");
  };
  ScenePipeline pipeline(sink, reporter, 3);
  const auto goOn = [&] {
    pipeline.add(pending(0), kSmall);
    pipeline.add(pending(1), kSmall);
    pipeline.add(failing(), kSmall);
    pipeline.finish();
  };
  EXPECT_THAT(test::messagesOf(goOn), testing::ElementsAre(HasSubstr("the disk is full")));
  EXPECT_THAT(indicesInSink(), ElementsAre(0));
}

}  // namespace scene_pipeline_test
}  // namespace synthetic_dataset::run
