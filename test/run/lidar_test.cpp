/// Runs with lidars, from settings to files.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "all_at_once_run.h"
#include "lidar/lidar_options.h"
#include "output/verify/dataset_verifier.h"
#include "run/merger.h"
#include "run/scene_loop.h"
#include "run/setup/run_setup.h"
#include "run_fixture.h"
#include "support/fake_scene_sink.h"
#include "support/verification_list.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace lidar_test {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Key;

Value list(const std::vector<double>& numbers) {
  return Value(Value::List(numbers.begin(), numbers.end()));
}

/// A scanner of 8 rings half a metre above the ground, a metre in front of `alpha` and `bravo`.
Value::Map scanner() {
  return {{"beams",
           Value(Value::Map{{"count", Value(8)}, {"first", Value(-0.4)}, {"last", Value(0.1)}})},
          {"columns", Value(360)},
          {"rate", Value(10.0)},
          {"min_range", Value(0.05)},
          {"pose", Value(Value::Map{{"position", list({-1.0, 0.2, 0.5})},
                                    {"rpy", list({0.0, 0.0, 0.0})}})}};
}

void addLidar(Value::Map& parameters, const Value::Map& lidar) {
  parameters["lidars"] = Value(Value::Map{{"top", Value(lidar)}});
}

Value writerOf(const std::string& name) {
  return Value(Value::Map{{"name", Value(name)}, {"type", Value("synthetic_dataset/" + name)}});
}

void writeClouds(Value::Map& parameters) {
  parameters["writers"] =
      Value(Value::List{writerOf("SemanticKitti"), writerOf("Kitti"), writerOf("RosBag"),
                        writerOf("KittiTracking"), writerOf("NuScenes")});
  parameters["Kitti"] = Value(Value::Map{{"velodyne", Value("top")}, {"min_points", Value(25)}});
  parameters["NuScenes"] = Value(Value::Map{{"min_points", Value(25)}});
  parameters["KittiTracking"] = Value(Value::Map{{"velodyne", Value("top")}});
  for (const char* unused : {"yolo", "bounding_shape", "stvnet"}) parameters.erase(unused);
}

class LidarRun : public test::RunFixture {
 protected:
  void SetUp() override {
    if (!lidar::canCastRays()) GTEST_SKIP() << lidar::howToCastRays();
    addLidar(parameters, scanner());
  }

  [[nodiscard]] std::vector<FinishedScene> scenes() const {
    Reporter silent;
    RunSetup setup = setUpRun(Value(parameters), {test::pluginXml()});
    test::FakeSceneSink sink;
    sink.required.clouds = true;
    (void)SceneLoop(setup, sink, silent).run();
    return sink.scenes;
  }

  Value::Map& top() {
    return *parameters.at("lidars").as<Value::Map>()->at("top").as<Value::Map>();
  }
};

TEST_F(LidarRun, MeasuresTheObjectsWhereTheyAreAtEachPointsTime) {
  const std::vector<FinishedScene> all = scenes();
  ASSERT_FALSE(all.empty());
  for (const FinishedScene& each : all) {
    const Scene& scene = each.scene;
    ASSERT_EQ(scene.clouds().size(), 1U);
    const Cloud& cloud = *scene.clouds().front();
    EXPECT_GT(cloud.points_of_objects.at(0), 20);
    EXPECT_GT(cloud.points_of_objects.at(1), 20);
    EXPECT_TRUE(cloud.X_GS.isApprox(scene.transform("map", "top/lidar_link")));
    for (const CloudPoint& point : cloud.points) {
      if (point.instance != 1) continue;
      // `alpha` drives along y at 1 m/s; at the stamp it is at the scene's pose.
      const Eigen::Vector3d p_G = cloud.X_GS * point.position_S.cast<double>();
      Eigen::Vector3d p_O = scene.objects[0].X_GO->inverse() * p_G;
      p_O.y() -= 1e-9 * point.time;
      const double from_side = std::max(std::abs(p_O.x()), std::abs(p_O.y())) - 0.2;
      EXPECT_NEAR(std::max(from_side, p_O.z() - 0.4), 0.0, 1e-4);  // it is 0.4 m high
    }
  }
}

TEST_F(LidarRun, ComputesNoCloudsThatNobodyAsksFor) {
  Reporter silent;
  RunSetup setup = setUpRun(Value(parameters), {test::pluginXml()});
  test::FakeSceneSink sink;
  (void)SceneLoop(setup, sink, silent).run();
  EXPECT_FALSE(sink.scenes.front().scene.clouds.isKnown());
}

TEST_F(LidarRun, RidesOnAnObject) {
  top()["mounted_on"] = Value("alpha");
  top()["pose"] =
      Value(Value::Map{{"position", list({0.0, 0.0, 1.0})}, {"rpy", list({0.0, 0.0, 0.0})}});
  const FinishedScene first = std::move(scenes().front());
  const Pose X_OS = first.scene.objects[0].X_GO->inverse() * first.scene.clouds().front()->X_GS;
  EXPECT_TRUE(X_OS.translation().isApprox(Eigen::Vector3d(0.0, 0.0, 1.0)));
}

TEST_F(LidarRun, TakesASensorOfAnObjectsModel) {
  Value::Map& alpha = *parameters.at("alpha").as<Value::Map>();
  alpha["model"] = Value(
      "<sdf version='1.6'><model name='m'><link name='b'><sensor name='scan' type='ray'>"
      "<pose>0 0 0.7 0 0 0</pose><ray><scan><horizontal><samples>181</samples>"
      "<min_angle>-1.57</min_angle><max_angle>1.57</max_angle></horizontal></scan>"
      "<range><min>0.1</min><max>50</max></range></ray></sensor><visual name='v'><geometry><box>"
      "<size>0.4 0.4 0.4</size></box></geometry></visual></link></model></sdf>");
  top() = {{"sensor", Value("alpha::b::scan")}};
  const FinishedScene first = std::move(scenes().front());
  const Cloud& cloud = *first.scene.clouds().front();
  EXPECT_EQ(cloud.columns, 181);
  const Pose X_OS = first.scene.objects[0].X_GO->inverse() * cloud.X_GS;
  EXPECT_TRUE(X_OS.translation().isApprox(Eigen::Vector3d(0.0, 0.0, 0.7)));
  EXPECT_TRUE(cloud.X_GS.isApprox(first.scene.transform("map", "top/lidar_link")));
}

TEST_F(LidarRun, WritesFilesThatVerifyFindsRight) {
  writeClouds(parameters);
  const auto files = filesAnew();
  EXPECT_THAT(files, Contains(Key("SemanticKitti/sequences/00/velodyne/000000.bin")));
  EXPECT_THAT(files, Contains(Key("SemanticKitti/sequences/00/poses.txt")));
  EXPECT_THAT(files, Contains(Key("Kitti/training/velodyne/000000.bin")));
  EXPECT_THAT(files, Contains(Key("KittiTracking/training/velodyne/0000/000000.bin")));
  EXPECT_EQ(files.at("SemanticKitti/sequences/00/velodyne/000000.bin"),
            files.at("Kitti/training/velodyne/000000.bin"));
  EXPECT_EQ(files.at("SemanticKitti/sequences/00/velodyne/000000.bin").size(),
            4 * files.at("SemanticKitti/sequences/00/labels/000000.label").size());
  test::VerificationList listener;
  output::WriterLoader& writers = *new output::WriterLoader({test::pluginXml()});
  (void)output::verifyDataset(folder, output::VerificationDepth::kLabels, listener, writers);
  EXPECT_THAT(listener.problems, IsEmpty());
}

TEST_F(LidarRun, WritesFilesThatVerifyFindsRightOfMotionsThatHaveItAlone) {
  writeClouds(parameters);
  const Value lidars = parameters.at("lidars");
  parameters.erase("lidars");
  parameters["motions"] = Value(Value::List{Value(Value::Map{{"lidars", lidars}})});
  (void)filesAnew();
  test::VerificationList listener;
  output::WriterLoader& writers = *new output::WriterLoader({test::pluginXml()});
  (void)output::verifyDataset(folder, output::VerificationDepth::kLabels, listener, writers);
  EXPECT_THAT(listener.problems, IsEmpty());
}

TEST_F(LidarRun, NamesWhatIsWrongWithItsSettings) {
  top()["rate"] = Value(2.0);
  top()["max_range"] = Value(0.01);
  top()["azimuth"] = list({0.0, 7.0});
  top()["colunms"] = Value(3);
  EXPECT_THAT(errors(),
              ::testing::AllOf(Contains(HasSubstr("lidars/top/rate: found 2.0 Hz")),
                               Contains(HasSubstr("lidars/top/max_range")),
                               Contains(HasSubstr("lidars/top/azimuth: found [0.0, 7.0]")),
                               Contains(HasSubstr("lidars/top/colunms"))));
}

TEST_F(LidarRun, AsksForAPose) {
  top().erase("pose");
  EXPECT_THAT(errors(), Contains(HasSubstr("lidars/top: nothing says where it is")));
}

TEST_F(LidarRun, NamesTheLidarThatAWriterMisspells) {
  writeClouds(parameters);
  parameters["Kitti"] = Value(Value::Map{{"velodyne", Value("tpo")}});
  EXPECT_THAT(errors(), ElementsAre(HasSubstr("Kitti/velodyne: found 'tpo'; it should be one of "
                                              "the run's lidars (top); did you mean 'top'?")));
}

/// A lidar run in which much goes on: two cameras, a ball that falls, noise.
class BrokenLidarRun : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!lidar::canCastRays()) GTEST_SKIP() << lidar::howToCastRays();
    Value::Map lidar = scanner();
    lidar["noise"] = Value(0.02);
    lidar["dropout"] = Value(0.1);
    addLidar(run.parameters, lidar);
    auto& writers = *run.parameters.at("writers").as<Value::List>();  // with a bag among them
    writers.push_back(writerOf("SemanticKitti"));
    writers.push_back(writerOf("Kitti"));
    run.parameters["Kitti"] = Value(Value::Map{{"velodyne", Value("top")}});
    run.parameters["simulated_rate"] = Value(8.0);
  }

  test::AllAtOnceRun run;
};

TEST_F(BrokenLidarRun, GivesTheBytesOfAnUnbrokenOne) {
  (void)run.run();
  const auto unbroken = test::AllAtOnceRun::files(run.folder());
  ASSERT_GT(unbroken.size(), 30U);
  fs::remove_all(run.folder());
  test::StoppingReporter stopping(3);
  EXPECT_TRUE(run.run(stopping, run.folder()).stopped);
  (void)run.run();
  EXPECT_TRUE(test::AllAtOnceRun::files(run.folder()) == unbroken);
}

TEST_F(BrokenLidarRun, GivesTheBytesOfASingleOneInShards) {
  (void)run.run();
  const auto single = test::AllAtOnceRun::files(run.folder());
  fs::remove_all(run.folder());
  for (const int index : {1, 0}) (void)run.runShard(index, 2, run.folder());
  Reporter silent;
  (void)mergeShards(run.folder(), {}, silent, {test::pluginXml()});
  EXPECT_TRUE(test::AllAtOnceRun::files(run.folder()) == single);
}

}  // namespace lidar_test
}  // namespace synthetic_dataset::run
