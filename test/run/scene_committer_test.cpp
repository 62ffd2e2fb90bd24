#include "run/scene_committer.h"

#include <gmock/gmock.h>

#include "run/motion_run.h"
#include "run/open_output.h"
#include "setup/run_setup.h"
#include "support/tiny_run.h"
#include "synthetic_dataset/errors.h"
#include "writers/plugin_environment.h"

namespace synthetic_dataset {
namespace {

using testing::HasSubstr;

/// The scenes of the tiny run, drawn and still to be finished.
class CommittedScenes : public testing::Test {
 protected:
  static void SetUpTestSuite() { test::preparePluginEnvironment(); }

  CommittedScenes()
      : setup(setUpRun(Value(run_.parameters()), {test::pluginXml()})),
        store(openOutput(setup)),
        motion_(setup, setup.motions.front(),
                [this](PendingScene scene) { scenes.push_back(std::move(scene)); }) {
    const WorkPlan all(setup.instantCount(), 1, {}, {}, [](std::int64_t) { return false; });
    motion_.run(all, [] { return false; });
  }

  [[nodiscard]] std::int64_t committed() const { return store->counts().scenes; }

 private:
  test::TinyRun run_;

 protected:
  RunSetup setup;
  std::unique_ptr<output::DatasetStore> store;
  std::vector<PendingScene> scenes;

 private:
  MotionRun motion_;
};

TEST_F(CommittedScenes, AreAllThereAtTheEnd) {
  ASSERT_GE(scenes.size(), 3U);
  SceneCommitter committer(*setup.writers, *store);
  for (const PendingScene& scene : scenes) committer.add(scene);
  committer.finish();
  EXPECT_EQ(committed(), static_cast<std::int64_t>(scenes.size()));
  EXPECT_EQ(committer.takeCommitted().size(), scenes.size());
}

TEST_F(CommittedScenes, AreThoseBeforeOneThatCannotBeFinished) {
  SceneCommitter committer(*setup.writers, *store);
  committer.add(scenes[0]);
  committer.add(scenes[1]);
  const auto goOn = [&] {
    committer.add([]() -> FinishedScene { throw Error("no light"); });
    committer.add(scenes[2]);
    committer.finish();
  };
  EXPECT_THAT(goOn, testing::ThrowsMessage<Error>(HasSubstr("no light")));
  EXPECT_EQ(committed(), 2);
}

TEST_F(CommittedScenes, TellTheFirstErrorFirst) {
  SceneCommitter committer(*setup.writers, *store);
  const auto goOn = [&] {
    committer.add(scenes[0]);
    committer.add([this] {
      FinishedScene scene = scenes[1]();
      scene.facts.index = 0;  // is there already
      return scene;
    });
    committer.add([]() -> FinishedScene { throw Error("no light"); });
    committer.finish();
  };
  EXPECT_THAT(goOn, testing::Throws<Error>(
                        testing::Property(&Error::what, testing::Not(HasSubstr("no light")))));
  EXPECT_EQ(committed(), 1);
}

}  // namespace
}  // namespace synthetic_dataset
