/// Runs that label recorded clouds: those of a simulated lidar in a bag of the same scenes, so that
/// the labels are known.

#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include "lidar/lidar_options.h"
#include "output/verify/dataset_verifier.h"
#include "run/scene_loop.h"
#include "run/setup/run_setup.h"
#include "run_fixture.h"
#include "support/bag_builder.h"
#include "support/cloud_message.h"
#include "support/fake_scene_sink.h"
#include "support/verification_list.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace recorded_clouds_test {

namespace fs = std::filesystem;
using test::BagBuilder;
using test::milliseconds;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Value list(const std::vector<double>& numbers) {
  return Value(Value::List(numbers.begin(), numbers.end()));
}

class RecordedCloudsRun : public test::RunFixture {
 protected:
  void SetUp() override {
    if (!lidar::canCastRays()) GTEST_SKIP() << lidar::howToCastRays();
    for (const char* unused : {"yolo", "bounding_shape", "stvnet"}) parameters.erase(unused);
    write({"SemanticKitti"});
  }

  void write(const std::vector<std::string>& formats) {
    Value::List writers;
    for (const std::string& each : formats) {
      writers.emplace_back(
          Value::Map{{"name", Value(each)}, {"type", Value("synthetic_dataset/" + each)}});
    }
    parameters["writers"] = Value(writers);
  }

  /// A scanner of 8 rings on the object that drives, which sees the other one, the ground and a
  /// falling ball.
  static Value::Map mounting() {
    return {{"mounted_on", Value("alpha")},
            {"pose", Value(Value::Map{{"position", list({0.0, 0.1, 0.45})},
                                      {"rpy", list({0.0, 0.0, 0.3})}})}};
  }

  static Value::Map castLidar() {
    Value::Map lidar = mounting();
    lidar["beams"] =
        Value(Value::Map{{"count", Value(8)}, {"first", Value(-0.5)}, {"last", Value(0.1)}});
    lidar["columns"] = Value(720);
    lidar["rate"] = Value(10.0);
    return lidar;
  }

  static Value::Map recordedLidar(const std::string& topic = "/top/points") {
    Value::Map lidar = mounting();
    lidar["cloud_topic"] = Value(topic);
    return lidar;
  }

  void setLidar(const Value::Map& lidar) {
    parameters["lidars"] = Value(Value::Map{{"top", Value(lidar)}});
  }

  /// Adds a bag to the recording.
  void record(const std::string& bag) {
    parameters["bag_file"] =
        Value(Value::List{Value((run.folder() / "tiny.bag").string()), Value(bag)});
  }

  /// Writes the clouds of a simulated lidar into a bag, and names it as the recording.
  void recordCastClouds() {
    setLidar(castLidar());
    write({"RosBag"});
    parameters["output_folder"] = Value((run.folder() / "cast").string());
    (void)generate();
    for (const auto& entry : fs::recursive_directory_iterator(run.folder() / "cast")) {
      if (entry.path().extension() == ".bag") record(entry.path().string());
    }
    parameters["output_folder"] = Value(folder);
    write({"SemanticKitti"});
  }

  [[nodiscard]] std::vector<FinishedScene> scenes() const {
    Reporter silent;
    RunSetup setup = setUpRun(Value(parameters), {test::pluginXml()});
    test::FakeSceneSink sink;
    sink.required.clouds = true;
    (void)SceneLoop(setup, sink, silent).run();
    return sink.scenes;
  }

  [[nodiscard]] std::vector<std::string> warnings() const {
    return setUpRun(Value(parameters), {test::pluginXml()})
        .diagnostics.messages(base::Severity::kWarning);
  }
};

TEST_F(RecordedCloudsRun, HaveTheLabelsOfTheSimulatedOnesThatTheyWere) {
  setLidar(castLidar());
  const std::vector<FinishedScene> cast = scenes();
  recordCastClouds();
  setLidar(recordedLidar());
  const std::vector<FinishedScene> recorded = scenes();
  ASSERT_EQ(recorded.size(), cast.size());
  ASSERT_FALSE(cast.empty());
  std::size_t points = 0;
  std::size_t others = 0;
  for (std::size_t scene = 0; scene < cast.size(); ++scene) {
    EXPECT_EQ(recorded[scene].scene.stamp, cast[scene].scene.stamp);
    const Cloud& right = *cast[scene].scene.clouds().front();
    const Cloud& found = *recorded[scene].scene.clouds().front();
    EXPECT_TRUE(found.X_GS.isApprox(right.X_GS));
    EXPECT_EQ(found.rings, right.rings);
    EXPECT_EQ(found.columns, right.columns);
    ASSERT_EQ(found.points.size(), right.points.size());
    std::map<std::pair<unsigned, unsigned>, const CloudPoint*> by_place;
    for (const CloudPoint& point : found.points) by_place[{point.ring, point.column}] = &point;
    for (const CloudPoint& point : right.points) {
      const CloudPoint* const same = by_place[{point.ring, point.column}];
      ASSERT_NE(same, nullptr);
      EXPECT_EQ(same->position_S, point.position_S);
      EXPECT_TRUE(same->position_at_stamp_S.isApprox(point.position_at_stamp_S, 1e-5F));
      EXPECT_NEAR(same->time, point.time, 10) << "[ns], as 32 bits have seconds";
      EXPECT_NEAR(same->intensity, point.intensity, 1e-6F);
      ++points;
      const bool is_same = same->instance == point.instance &&
                           same->class_number == point.class_number &&
                           same->world_class == point.world_class && same->part == point.part;
      others += is_same ? 0 : 1;
    }
    EXPECT_GT(found.points_of_objects.at(0), 20);
    EXPECT_GT(found.points_of_objects.at(1), 20);
  }
  RecordProperty("points", static_cast<int>(points));
  RecordProperty("others", static_cast<int>(others));
  EXPECT_LE(others, points / 1000) << "of " << points << ", at edges";
}

TEST_F(RecordedCloudsRun, WriteFilesThatVerifyFindsRight) {
  recordCastClouds();
  setLidar(recordedLidar());
  write({"SemanticKitti", "Kitti", "RosBag", "KittiTracking", "NuScenes"});
  parameters["Kitti"] = Value(Value::Map{{"velodyne", Value("top")}});
  parameters["KittiTracking"] = Value(Value::Map{{"velodyne", Value("top")}});
  const auto files = filesAnew();
  EXPECT_EQ(files.at("SemanticKitti/sequences/00/velodyne/000000.bin").size(),
            4 * files.at("SemanticKitti/sequences/00/labels/000000.label").size());
  test::VerificationList listener;
  output::WriterLoader& writers = *new output::WriterLoader({test::pluginXml()});
  (void)output::verifyDataset(folder, output::VerificationDepth::kLabels, listener, writers);
  EXPECT_THAT(listener.problems, IsEmpty());
}

/// Clouds of a few points on the ground, from a scanner that is 1 m above it according to TF.
class HandMadeCloudsRun : public RecordedCloudsRun {
 protected:
  using Field = test::CloudFieldNumbers;

  /// A point on the ground straight ahead, measured before the stamp, and one in the air.
  static sensor_msgs::PointCloud2 cloudAt(std::int64_t stamp_ms, double seconds_before) {
    using sensor_msgs::PointField;
    return test::cloudMessage(
        "velodyne", milliseconds(stamp_ms),
        {Field{"x", PointField::FLOAT32, {1.0, 1.0}}, Field{"y", PointField::FLOAT32, {0.0, 0.0}},
         Field{"z", PointField::FLOAT32, {-1.0, -0.5}},
         Field{"time", PointField::FLOAT32, {-seconds_before, 0.0}}});
  }

  /// @param clouds  the clouds' stamps [ms]
  void recordHandMade(const std::vector<std::int64_t>& clouds) {
    BagBuilder bag(run.folder() / "scanner.bag");
    bag.fix("map", "velodyne", milliseconds(1000), test::poseAt(-2.0, -2.0, 1.0));
    for (const std::int64_t stamp : clouds) bag.cloud("/points", cloudAt(stamp, 0.02));
    bag.from("eye_optical");
    for (int i = 0; i < 4; ++i) {
      bag.picture("/eye/image_raw", milliseconds(1000 + 200 * i),
                  cv::Mat(120, 160, CV_8UC3, cv::Scalar::all(9)), "bgr8");
    }
    record(bag.close());
    setLidar({{"cloud_topic", Value("/points")}});
  }

  void takeRecordedPictures() {
    Value::Map camera = *parameters.at("camera").as<Value::Map>();
    camera["image_topic"] = Value("/eye/image_raw");
    parameters["camera"] = Value(camera);
    parameters.erase("simulated_rate");
  }

  Value::Map& top() {
    return *parameters.at("lidars").as<Value::Map>()->at("top").as<Value::Map>();
  }

  [[nodiscard]] std::vector<Stamp> stamps() const {
    std::vector<Stamp> stamps;
    for (const FinishedScene& each : scenes()) stamps.push_back(each.scene.stamp);
    return stamps;
  }
};

TEST_F(HandMadeCloudsRun, AreAtTheCloudsStampsInTheCloudsFrame) {
  recordHandMade({1200, 1300, 1410});
  parameters["world_classes"] = Value(Value::Map{{"ground", Value(Value::List{Value("floor")})}});
  const std::vector<FinishedScene> all = scenes();
  ASSERT_THAT(all, SizeIs(3));
  EXPECT_EQ(all[2].scene.stamp, milliseconds(1410));
  const Cloud& cloud = *all[0].scene.clouds().front();
  EXPECT_TRUE(cloud.X_GS.isApprox(test::poseAt(-2.0, -2.0, 1.0)));
  EXPECT_TRUE(all[0].scene.transform("map", "velodyne").isApprox(cloud.X_GS));
  ASSERT_THAT(cloud.points, SizeIs(2));
  EXPECT_EQ(cloud.points[0].world_class, 1);
  EXPECT_NEAR(cloud.points[0].time, -20'000'000, 2);
  EXPECT_EQ(cloud.points[1].world_class, 0);
  ASSERT_THAT(all[0].facts.warnings,
              Contains(testing::Field(&base::Warning::kind,
                                      HasSubstr("lidars/top/cloud_topic: points without label"))));
  for (const base::Warning& each : all[0].facts.warnings) {
    const bool is_of_points = each.kind.find("points without label") != std::string::npos;
    EXPECT_TRUE(!is_of_points || each.count == 1);
  }
}

TEST_F(HandMadeCloudsRun, TakesEveryOtherCloud) {
  recordHandMade({1200, 1300, 1400, 1500});
  top()["every"] = Value(2);
  EXPECT_THAT(stamps(), ElementsAre(milliseconds(1200), milliseconds(1400)));
}

TEST_F(HandMadeCloudsRun, GoWithRecordedPicturesThatAreNear) {
  recordHandMade({1030, 1190, 1700});
  takeRecordedPictures();
  const std::vector<FinishedScene> all = scenes();
  ASSERT_THAT(all, SizeIs(2)) << "no cloud is near the pictures at 1.4 s and 1.6 s";
  EXPECT_EQ(all[0].scene.stamp, milliseconds(1000));
  EXPECT_EQ(all[1].scene.stamp, milliseconds(1200));
  const Cloud& cloud = *all[1].scene.clouds().front();
  EXPECT_NEAR(cloud.points[0].time, -30'000'000, 2) << "since the picture's stamp";
  EXPECT_THAT(warnings(), Contains(HasSubstr("lidars/top/cloud_topic: scene left out: there is no "
                                             "cloud within 60 ms (lidars/top/cloud_time)")));
}

TEST_F(HandMadeCloudsRun, NamesWhatIsMissing) {
  recordHandMade({1200});
  top()["cloud_topic"] = Value("/pionts");
  EXPECT_THAT(errors(),
              Contains(AllOf(HasSubstr("lidars/top/cloud_topic: "), HasSubstr("did you mean"))));
}

TEST_F(HandMadeCloudsRun, NamesAFrameThatTfDoesNotHave) {
  recordHandMade({1200});
  BagBuilder bag(run.folder() / "lost.bag");
  bag.from("velodine").cloud("/points", milliseconds(1200), {{1, 0, -1}});
  record(bag.close());
  EXPECT_THAT(errors(),
              Contains(AllOf(HasSubstr("lidars/top/cloud_topic: found clouds of the frame "
                                       "'velodine', of which nothing says where it is"),
                             HasSubstr("lidars/top/pose should"))));
}

TEST_F(HandMadeCloudsRun, NamesCloudsThatCannotBeRead) {
  BagBuilder bag(run.folder() / "flat.bag");
  bag.fix("map", "velodyne", milliseconds(1000), test::poseAt(-2.0, -2.0, 1.0));
  sensor_msgs::PointCloud2 flat = cloudAt(1200, 0.0);
  flat.fields[2].name = "height";
  bag.cloud("/points", flat);
  record(bag.close());
  setLidar({{"cloud_topic", Value("/points")}});
  EXPECT_THAT(errors(), ElementsAre(HasSubstr("lidars/top/cloud_topic: the cloud of '/points' at "
                                              "1.200000000 s has no field z")));
}

TEST_F(HandMadeCloudsRun, RefusesWhatWasNotThere) {
  recordHandMade({1200});
  parameters["randomize"] = Value(Value::Map{
      {"time",
       Value(Value::Map{{"jitter", Value(Value::Map{{"uniform", list({-0.01, 0.01})}})}})}});
  EXPECT_THAT(errors(), Contains(HasSubstr("randomize/time: found together with cloud_topic")));
  parameters.erase("randomize");
  parameters["motion"] = Value("placement");
  EXPECT_THAT(errors(), Contains(HasSubstr("motion: found placement, and a lidar with a "
                                           "cloud_topic")));
}

TEST_F(HandMadeCloudsRun, RefusesSweepsThatPhysicsCannotGoBackFor) {
  recordHandMade({1200, 1210});  // each begins 20 ms before
  EXPECT_THAT(errors(), Contains(HasSubstr("the clouds of two scenes overlap by 10 ms, and the "
                                           "world has models moved by physics")));
}

}  // namespace recorded_clouds_test
}  // namespace synthetic_dataset::run
