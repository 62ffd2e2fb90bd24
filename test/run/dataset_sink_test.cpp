#include "run/dataset_sink.h"

#include <gmock/gmock.h>

#include "run/scene_loop.h"
#include "support/tiny_run.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace dataset_sink_test {

using testing::ElementsAre;
using testing::IsEmpty;

/// The tiny run's four scenes of one camera.
class DatasetSinkTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { test::preparePluginEnvironment(); }

  [[nodiscard]] RunSetup setUp() const { return setUpRun(Value(parameters), {test::pluginXml()}); }

  [[nodiscard]] static std::vector<std::int64_t> wantedBy(const DatasetSink& sink) {
    std::vector<std::int64_t> scenes;
    for (std::int64_t scene = 0; scene < 4; ++scene) {
      if (sink.wants(scene)) scenes.push_back(scene);
    }
    return scenes;
  }

  test::TinyRun run;
  Value::Map parameters = run.parameters();
};

TEST_F(DatasetSinkTest, WantsTheScenesOfItsShard) {
  parameters["shard"] = Value(Value::Map{{"index", Value(1)}, {"count", Value(2)}});
  const RunSetup setup = setUp();
  DatasetSink sink(setup);
  sink.begin({});
  EXPECT_THAT(wantedBy(sink), ElementsAre(1, 3));
  EXPECT_EQ(sink.plannedCount(), 2);
}

TEST_F(DatasetSinkTest, WantsTheChosenScenesUntilTheyAreThere) {
  parameters["only_scenes"] = Value(Value::List{Value(1), Value(3)});
  RunSetup setup = setUp();
  DatasetSink sink(setup);
  Reporter silent;
  SceneLoop loop(setup, sink, silent);
  EXPECT_THAT(wantedBy(sink), ElementsAre(1, 3));
  EXPECT_EQ(loop.run().scenes, 2);
  EXPECT_THAT(wantedBy(sink), IsEmpty());
  EXPECT_EQ(sink.plannedCount(), 2);
  EXPECT_EQ(sink.store().counts().scenes, 2);
}

}  // namespace dataset_sink_test
}  // namespace synthetic_dataset::run
