/// Objects of the world that are not in the recording, as seen by a camera that rides along.

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "config/settings_file.h"
#include "output/verify/dataset_verifier.h"
#include "run/generator.h"
#include "run/scene_loop.h"
#include "run/setup/run_setup.h"
#include "support/bag_builder.h"
#include "support/error_messages.h"
#include "support/fake_scene_sink.h"
#include "support/temporary_folder.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace world_objects_test {

using test::milliseconds;

using test::poseAt;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A street with two parked cars, a falling ball and no robot; the recording has a frame that
/// drives along it.
constexpr char kStreet[] = R"(<sdf version="1.6"><world name="street">
<light name="sun" type="directional"><direction>0.3 0.4 -1</direction></light>
<model name="floor"><static>true</static><link name="body">
  <collision name="c"><pose>0 0 -0.1 0 0 0</pose><geometry><box><size>40 8 0.2</size></box></geometry></collision>
  <visual name="v"><pose>0 0 -0.1 0 0 0</pose><geometry><box><size>40 8 0.2</size></box></geometry></visual></link></model>
<model name="car_1"><static>true</static><pose>6 1 0 0 0 0</pose><link name="body">
  <collision name="c"><pose>0 0 0.5 0 0 0</pose><geometry><box><size>2 1 1</size></box></geometry></collision>
  <visual name="v"><pose>0 0 0.5 0 0 0</pose><geometry><box><size>2 1 1</size></box></geometry></visual></link></model>
<model name="car_2"><static>true</static><pose>9 -1 0 0 0 1.5707963</pose><link name="body">
  <visual name="v"><pose>0 0 0.5 0 0 0</pose><geometry><box><size>2 1 1</size></box></geometry></visual></link></model>
<model name="ball"><pose>7 0 2 0 0 0</pose><link name="body">
  <inertial><mass>0.2</mass><inertia><ixx>0.001</ixx><iyy>0.001</iyy><izz>0.001</izz></inertia></inertial>
  <collision name="c"><geometry><sphere><radius>0.2</radius></sphere></geometry></collision>
  <visual name="v"><geometry><sphere><radius>0.2</radius></sphere></geometry></visual></link></model>
</world></sdf>
)";

constexpr char kCone[] = R"(<sdf version="1.6"><model name="cone"><link name="body">
<visual name="v"><pose>0 0 0.25 0 0 0</pose><geometry><box><size>0.4 0.4 0.5</size></box></geometry></visual>
</link></model></sdf>)";

class WorldObjectsTest : public ::testing::Test {
 protected:
  WorldObjectsTest() {
    test::preparePluginEnvironment();
    folder_.write("street.world", kStreet);
    folder_.write("cone.sdf", kCone);
    folder_.write("camera.yaml", R"(image_width: 160
image_height: 120
camera_matrix: {rows: 3, cols: 3, data: [140, 0, 79.5, 0, 140, 59.5, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}
)");
    test::BagBuilder bag(folder_ / "drive.bag");
    for (int i = 0; i <= 20; ++i) {
      bag.move("map", "base_link", milliseconds(1000 + 50 * i), poseAt(0.1 * i, 0.0, 0.0));
    }
    bag.close();
    set("bag_file", path("drive.bag"));
    set("simulated_rate", "4");
    set("world", path("street.world"));
    set("camera", "{info_file: " + path("camera.yaml") +
                      ", mounted_on: base_link, pose: {position: [0, 0, 0.6], rpy: [0, 0, 0]}}");
    set("output_folder", path("out"));
    set("writers", "[{name: coco, type: synthetic_dataset/Coco}]");
  }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }

  void set(const std::string& name, const std::string& text) {
    for (const auto& [setting, value] : config::settingOf(name, text)) {
      parameters[setting] = value;
    }
  }

  /// Makes all scenes; the sink has their dataset as well.
  const test::FakeSceneSink& scenes() {
    RunSetup setup = setUpRun(Value(parameters), {test::pluginXml()});
    for (const base::Diagnostic& each : setup.diagnostics.all()) said.push_back(each.message());
    sink_ = std::make_unique<test::FakeSceneSink>();
    sink_->required.visible_masks = sink_->required.silhouettes = true;
    Reporter silent;
    (void)SceneLoop(setup, *sink_, silent).run();
    return *sink_;
  }

  [[nodiscard]] std::vector<std::string> errors() const {
    return test::messagesOf([&] { (void)setUpRun(Value(parameters), {test::pluginXml()}); });
  }

  static const SceneObject& find(const Scene& scene, const std::string& name) {
    return *std::find_if(scene.objects.begin(), scene.objects.end(),
                         [&](const SceneObject& each) { return each.name == name; });
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<test::FakeSceneSink> sink_;
  Value::Map parameters;
  std::vector<std::string> said;
};

TEST_F(WorldObjectsTest, ARidingCameraSeesTheWorldsModelsAsObjects) {
  set("world_objects", "[{class: car, models: 'car_*'}]");
  const test::FakeSceneSink& sink = scenes();
  ASSERT_THAT(sink.scenes, SizeIs(4));
  for (const FinishedScene& each : sink.scenes) {
    ASSERT_THAT(each.scene.objects, SizeIs(2));
    const SceneObject& car = find(each.scene, "car_1");
    EXPECT_EQ(car.class_name, "car");
    EXPECT_GT(car.pixels.visible(), 100);
    EXPECT_TRUE(car.X_GO->translation().isApprox(Eigen::Vector3d(6, 1, 0)));
    EXPECT_TRUE(car.cuboid_O.high.isApprox(Eigen::Vector3d(1, 0.5, 1), 1e-6));
    // A quarter of a turn, in the model's own frame as in its file.
    EXPECT_TRUE(
        find(each.scene, "car_2").X_GO->linear().col(0).isApprox(Eigen::Vector3d(0, 1, 0), 1e-6));
  }
}

TEST_F(WorldObjectsTest, AnObjectThatPhysicsMovesIsWhereItFalls) {
  set("world_objects", "[{class: ball, models: ball}]");
  const test::FakeSceneSink& sink = scenes();
  ASSERT_THAT(sink.scenes, SizeIs(4));
  double height = 2.1;
  for (const FinishedScene& each : sink.scenes) {
    const SceneObject& ball = find(each.scene, "ball");
    // Free fall from 2 m, until it lies on the floor.
    const double t = toSeconds(each.scene.stamp) - toSeconds(sink.scenes.front().scene.stamp);
    EXPECT_NEAR(ball.X_GO->translation().z(), std::max(0.2, 2.0 - 0.5 * 9.81 * t * t), 0.12);
    EXPECT_LT(ball.X_GO->translation().z(), height);
    height = ball.X_GO->translation().z();
  }
  EXPECT_GT(sink.scenes.back().scene.objects.front().pixels.visible(), 10);
}

TEST_F(WorldObjectsTest, AnObjectWithAModelStandsWhereItsPoseSays) {
  set("robot_list", "[cone]");
  set("cone", "{class: cone, id: 1, model: " + path("cone.sdf") +
                  ", pose: {position: [4, -1, 0], rpy: [0, 0, 0]}}");
  const test::FakeSceneSink& sink = scenes();
  ASSERT_THAT(sink.scenes, SizeIs(4));
  const SceneObject& cone = sink.scenes.front().scene.objects.front();
  EXPECT_TRUE(cone.X_GO->translation().isApprox(Eigen::Vector3d(4, -1, 0)));
  EXPECT_GT(cone.pixels.visible(), 50);
}

TEST_F(WorldObjectsTest, ADatasetOfThemIsVerified) {
  set("world_objects",
      "[{class: car, models: 'car_*', keypoints: {farthest_points: 4}}, "
      "{class: ball, models: ball}]");
  Reporter silent;
  Generator(Value(parameters), silent, {test::pluginXml()}).run();
  struct Listener : output::VerificationListener {
    void problem(const std::string& line) override { problems.push_back(line); }
    void remark(const std::string& /*line*/) override {}
    void progress(std::int64_t /*scene_count*/, std::int64_t /*of*/) override {}
    std::vector<std::string> problems;
  } listener;
  (void)output::verifyDataset(path("out"), output::VerificationDepth::kLabels, listener);
  EXPECT_THAT(listener.problems, IsEmpty());
}

TEST_F(WorldObjectsTest, WorldClassesLeaveObjectsOut) {
  set("world_objects", "[{class: car, models: 'car_*'}]");
  set("world_classes", "{vehicle: ['car_*'], floor: [floor]}");
  const test::FakeSceneSink& sink = scenes();
  EXPECT_THAT(sink.dataset->world_classes, ElementsAre("floor", "vehicle"));
  EXPECT_THAT(said, ::testing::Not(Contains(HasSubstr("nothing in the world is called 'car_*'"))));
}

TEST_F(WorldObjectsTest, SaysWhatIsNotThere) {
  set("world_objects", "[{class: car, models: 'car_*'}, {class: tree, models: 'flor'}]");
  (void)scenes();
  EXPECT_THAT(said, Contains("world_objects/1/models: nothing in the world is called 'flor'; did "
                             "you mean 'floor'?"));
  set("world_objects", "[{class: car, models: 'lorry_*'}]");
  EXPECT_THAT(errors(), Contains(HasSubstr("world_objects: no model of the world matches")));
}

TEST_F(WorldObjectsTest, ChecksWhatIsWritten) {
  set("world_objects", "[{clas: car, models: 'car_*'}]");
  EXPECT_THAT(errors(), Contains("world_objects/0/clas: unknown parameter; did you mean 'class'?"));
  set("world_objects", "[{class: car, models: 'car_*'}, {class: bus, models: car_2}]");
  EXPECT_THAT(errors(), Contains(HasSubstr("'car_2' is in world_objects/0, too")));
}

TEST_F(WorldObjectsTest, AnObjectStandsOrFollowsAFrame) {
  set("robot_list", "[cone]");
  set("cone", "{class: cone, id: 1, model: " + path("cone.sdf") +
                  ", frame: base_link, pose: [4, -1, 0, 0, 0, 0, 1]}");
  EXPECT_THAT(errors(), Contains(HasSubstr("cone/frame: found together with pose")));
  set("cone", "{class: cone, id: 1, model: " + path("cone.sdf") + ", pose: here}");
  EXPECT_THAT(errors(), Contains(HasSubstr("cone/pose: found 'here'; it should be [x, y, z, qx")));
}

}  // namespace world_objects_test
}  // namespace synthetic_dataset::run
