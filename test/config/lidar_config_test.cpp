#include <gmock/gmock.h>

#include "config/readers.h"

namespace synthetic_dataset::config {
namespace lidar_config_test {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class LidarConfig : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!lidar::canCastRays()) GTEST_SKIP() << lidar::howToCastRays();
  }

  /// The lidar "top" with these settings.
  lidar::LidarOptions read(const Value::Map& settings) {
    Parameters root(Value(Value::Map{{"lidars", Value(Value::Map{{"top", Value(settings)}})}}));
    const auto lidars = readLidars(root, {});
    errors_ = root.errors();
    return lidars.front();
  }

  static Value list(const std::vector<double>& numbers) {
    return Value(Value::List(numbers.begin(), numbers.end()));
  }

  std::vector<std::string> errors_;
};

TEST_F(LidarConfig, TakesAModelAndWhatIsSetBesideIt) {
  const lidar::LidarOptions top = read({{"model", "VLP-16"}, {"rate", 20.0}, {"noise", 0.0}});
  EXPECT_THAT(errors_, IsEmpty());
  EXPECT_EQ(top.frame, "top/lidar_link");
  EXPECT_THAT(top.model.elevations, SizeIs(16));
  EXPECT_EQ(lidar::columnsOf(top.model), 904);
  EXPECT_EQ(top.model.noise, 0.0);
  EXPECT_EQ(top.model.max_range, 100.0);
}

TEST_F(LidarConfig, TakesBeamsOfItsOwn) {
  const lidar::LidarOptions top =
      read({{"beams", Value::Map{{"elevations", list({-0.1, 0.0, 0.1})},
                                 {"firing_times", list({0.0, 1e-6, 2e-6})}}},
            {"columns", 100},
            {"azimuth", list({-1.0, 1.0})},
            {"pose", Value::Map{{"position", list({1, 2, 3})}, {"rpy", list({0, 0, 0})}}}});
  EXPECT_THAT(errors_, IsEmpty());
  EXPECT_THAT(top.model.elevations, ElementsAre(-0.1, 0.0, 0.1));
  EXPECT_EQ(lidar::columnsOf(top.model), 100);
  EXPECT_EQ(top.model.last_azimuth, 1.0);
  EXPECT_TRUE(top.X_GS->translation().isApprox(Eigen::Vector3d(1, 2, 3)));
}

TEST_F(LidarConfig, NamesWhatIsWrong) {
  (void)read({{"model", "VLP-17"},
              {"beams", Value::Map{{"elevations", list({3.0})}, {"count", 4}}},
              {"min_range", -1.0},
              {"azimuth", list({0.0})},
              {"pose", list({1, 2, 3})}});
  EXPECT_THAT(errors_,
              AllOf(Contains(HasSubstr("lidars/top/model: found 'VLP-17'")),
                    Contains(HasSubstr("lidars/top/beams/elevations: found [3.0]")),
                    Contains(HasSubstr("lidars/top/beams/count")),
                    Contains(HasSubstr("lidars/top/min_range")),
                    Contains(HasSubstr("lidars/top/azimuth: found [0.0]; it should be")),
                    Contains(HasSubstr("lidars/top/pose: found 3 numbers; it should be"))));
}

TEST_F(LidarConfig, AsksForAModelOrBeams) {
  (void)read({});
  EXPECT_THAT(errors_,
              ElementsAre(AllOf(HasSubstr("lidars/top/model: missing, and so are beams and sensor"),
                                HasSubstr("UTM-30LX"))));
}

TEST_F(LidarConfig, TakesASensorOfTheWorldAndWhatIsSetBesideIt) {
  const lidar::LidarOptions top = read({{"sensor", "mast::link::scan"}, {"noise", 0.02}});
  EXPECT_THAT(errors_, IsEmpty());
  EXPECT_EQ(top.sensor, "mast::link::scan");
  EXPECT_EQ(top.changes.noise, 0.02);
  EXPECT_FALSE(top.changes.max_range);
}

TEST_F(LidarConfig, RefusesRaysBesideThoseOfASensor) {
  (void)read({{"sensor", "mast::link::scan"}, {"model", "VLP-16"}, {"columns", 7}});
  EXPECT_THAT(errors_, ElementsAre(HasSubstr("lidars/top/model: has a meaning with no sensor"),
                                   HasSubstr("lidars/top/columns")));
}

TEST_F(LidarConfig, TakesRecordedClouds) {
  const lidar::LidarOptions top = read({{"cloud_topic", "/points"},
                                        {"label_tolerance", 0.05},
                                        {"time_offset", -0.1},
                                        {"full_intensity", 1.0}});
  EXPECT_THAT(errors_, IsEmpty());
  ASSERT_TRUE(top.recorded);
  EXPECT_EQ(top.recorded->topic, "/points");
  EXPECT_EQ(top.recorded->tolerance, 0.05);
  EXPECT_EQ(top.recorded->time_offset, std::chrono::milliseconds(-100));
  EXPECT_EQ(top.recorded->full_intensity, 1.0);
  EXPECT_EQ(top.recorded->longest_distance, std::chrono::milliseconds(60));
  EXPECT_EQ(top.frame, "") << "the clouds say it";
}

TEST_F(LidarConfig, RefusesRaysBesideRecordedClouds) {
  (void)read({{"cloud_topic", "/points"}, {"model", "VLP-16"}, {"noise", 0.1}});
  EXPECT_THAT(errors_, ElementsAre(HasSubstr("lidars/top/model: found together with cloud_topic; "
                                             "recorded points are as they were measured"),
                                   HasSubstr("lidars/top/noise")));
}

TEST_F(LidarConfig, RefusesWhatIsOfRecordedCloudsWithoutThem) {
  (void)read({{"model", "VLP-16"}, {"label_tolerance", 0.1}});
  EXPECT_THAT(errors_,
              ElementsAre(HasSubstr("lidars/top/label_tolerance: has a meaning with cloud_topic")));
}

TEST_F(LidarConfig, TakesEveryNthCloudOfTheFirstLidarAlone) {
  const auto errorsOf = [](bool has_pictures) {
    scene::CameraOptions camera;
    if (has_pictures) camera.image_topic = "/eye";
    const auto each = [](const char* topic) {
      return Value(Value::Map{{"cloud_topic", Value(topic)}, {"every", Value(5)}});
    };
    Parameters root(
        Value(Value::Map{{"lidars", Value::Map{{"a", each("/a")}, {"b", each("/b")}}}}));
    (void)readLidars(root, {camera});
    return root.errors();
  };
  EXPECT_THAT(errorsOf(false), ElementsAre(HasSubstr("lidars/b/every: found for a second lidar")));
  EXPECT_THAT(errorsOf(true), ElementsAre(HasSubstr("lidars/a/every: found beside a camera's"),
                                          HasSubstr("lidars/b/every: found beside a camera's")));
}

TEST_F(LidarConfig, RefusesTheFrameOfACamera) {
  scene::CameraOptions camera;
  camera.frame = "optical";
  Parameters root(Value(Value::Map{
      {"lidars", Value::Map{{"top", Value::Map{{"model", "VLP-16"}, {"frame_id", "optical"}}}}}}));
  (void)readLidars(root, {camera});
  EXPECT_THAT(root.errors(), ElementsAre(HasSubstr("lidars/top/frame_id: found 'optical'")));
}

TEST(LidarConfigWithoutEmbree, SaysWhatIsMissing) {
  if (lidar::canCastRays()) GTEST_SKIP() << "this build can cast rays";
  Parameters root(Value(Value::Map{{"lidars", Value::Map{{"top", Value::Map{}}}}}));
  EXPECT_THAT(readLidars(root, {}), IsEmpty());
  EXPECT_THAT(root.errors(), ElementsAre(HasSubstr("apt-get install libembree-dev")));
}

}  // namespace lidar_config_test
}  // namespace synthetic_dataset::config
