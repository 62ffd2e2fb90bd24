#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <map>

#include <gmock/gmock.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>
#include <opencv2/core.hpp>

#include "plugins/plugin_harness.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset {
namespace ros_bag_writer_test {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Pair;
using testing::UnorderedElementsAre;
using visualization_msgs::Marker;

class RosBag : public PluginTest {
 protected:
  RosBag() : PluginTest("synthetic_dataset/RosBag") {}

  /// A scene at 1 s, 2 s, ... whose pixels all differ.
  [[nodiscard]] static Scene timed(std::int64_t index, std::vector<SceneObject> objects) {
    Scene result = scene(index, std::move(objects));
    result.stamp = std::chrono::seconds(index + 1) + std::chrono::nanoseconds(123456789);
    for (int row = 0; row < 480; ++row) {
      for (int column = 0; column < 640; ++column) {
        result.image.at<cv::Vec3b>(row, column) = {static_cast<uchar>(row),
                                                   static_cast<uchar>(column),
                                                   static_cast<uchar>(row / 256 + index)};
      }
    }
    return result;
  }

  [[nodiscard]] std::string bagFile() const { return folder() + "dataset.bag"; }

  /// The messages of a topic, in the order of playing.
  template <class Message>
  [[nodiscard]] std::vector<Message> messages(const std::string& topic) const {
    const rosbag::Bag bag(bagFile());
    rosbag::View view(bag, rosbag::TopicQuery(topic));
    std::vector<Message> all;
    for (const rosbag::MessageInstance& each : view) all.push_back(*each.instantiate<Message>());
    return all;
  }

  /// How many messages each topic has.
  [[nodiscard]] std::map<std::string, int> counts() const {
    const rosbag::Bag bag(bagFile());
    rosbag::View view(bag);
    std::map<std::string, int> result;
    for (const rosbag::MessageInstance& each : view) ++result[each.getTopic()];
    return result;
  }

  /// The only message of a topic after a run of one scene.
  template <class Message>
  [[nodiscard]] Message onlyMessage(const std::string& topic) const {
    const std::vector<Message> all = messages<Message>(topic);
    if (all.size() != 1) throw Error(topic + " has " + std::to_string(all.size()) + " messages");
    return all.front();
  }

  [[nodiscard]] static cv::Mat pixelsOf(sensor_msgs::Image& message, int type) {
    return cv::Mat(static_cast<int>(message.height), static_cast<int>(message.width), type,
                   message.data.data(), message.step);
  }

  void clear() const {
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
      std::filesystem::remove_all(entry.path());
    }
  }
};

/// Turned by 90 degrees about z: x goes to y.
Pose turned(const Eigen::Vector3d& position) {
  return makePose(position, {std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)});
}

TEST_F(RosBag, HasEachTopicOnceAScene) {
  load({});
  runAll({timed(0, {}), timed(1, {}), timed(2, {})});
  EXPECT_THAT(counts(),
              UnorderedElementsAre(
                  Pair("/tf", 3), Pair("/camera/camera_info", 3), Pair("/camera/image_raw", 3),
                  Pair("/camera/instances", 3), Pair("/camera/depth/camera_info", 3),
                  Pair("/camera/depth/image_rect_raw", 3), Pair("/camera/objects", 3)));
}

TEST_F(RosBag, RecordsEveryMessageAtItsScenesTime) {
  load({});
  runAll({timed(0, {}), timed(1, {})});
  const rosbag::Bag bag(bagFile());
  rosbag::View view(bag);
  std::map<ros::Time, int> times;
  for (const rosbag::MessageInstance& each : view) ++times[each.getTime()];
  EXPECT_THAT(times, UnorderedElementsAre(Pair(ros::Time(1, 123456789), 7),
                                          Pair(ros::Time(2, 123456789), 7)));
  for (const auto& image : messages<sensor_msgs::Image>("/camera/image_raw")) {
    EXPECT_EQ(times.count(image.header.stamp), 1U);
  }
}

TEST_F(RosBag, HoldsTheImageByteForByte) {
  load({});
  const Scene only = timed(0, {});
  runAll({only});
  auto image = onlyMessage<sensor_msgs::Image>("/camera/image_raw");
  EXPECT_EQ(image.encoding, "bgr8");
  EXPECT_EQ(image.header.frame_id, "synthetic/camera/optical_link");
  EXPECT_EQ(cv::norm(pixelsOf(image, CV_8UC3), only.image, cv::NORM_L1), 0.0);
}

TEST_F(RosBag, HoldsThePngItselfWhenCompressed) {
  load({{"compressed", true}});
  runAll({timed(0, {})});
  const auto image = onlyMessage<sensor_msgs::CompressedImage>("/camera/image_raw/compressed");
  EXPECT_EQ(image.format, "bgr8; png compressed bgr8");
  EXPECT_EQ(std::string(image.data.begin(), image.data.end()),
            test::readFile(folder() + "images/00000000.png"));
  EXPECT_EQ(counts().count("/camera/image_raw"), 0U);
}

TEST_F(RosBag, HoldsInstancesAsSixteenBits) {
  load({});
  Scene only = timed(0, {seen("a", {10, 20, 30, 40})});
  cv::Mat(only.instance_map()).at<std::uint16_t>(100, 200) = 0x1234;
  runAll({only});
  auto image = onlyMessage<sensor_msgs::Image>("/camera/instances");
  EXPECT_EQ(image.encoding, "mono16");
  const cv::Mat pixels = pixelsOf(image, CV_16UC1);
  EXPECT_EQ(pixels.at<std::uint16_t>(100, 200), 0x1234);
  EXPECT_EQ(cv::norm(pixels, only.instance_map(), cv::NORM_L1), 0.0);
}

TEST_F(RosBag, HoldsEveryBitOfDepthAndNothingWhereNothingIs) {
  load({});
  Scene only = timed(0, {});
  const std::array<float, 4> depths = {0.1F, 3.14159274F, 99.9999924F, -2.5F};
  cv::Mat given = only.depth();
  for (int i = 0; i < 4; ++i) given.at<float>(7, i) = depths[static_cast<std::size_t>(i)];
  runAll({only});
  auto image = onlyMessage<sensor_msgs::Image>("/camera/depth/image_rect_raw");
  EXPECT_EQ(image.encoding, "32FC1");
  const cv::Mat pixels = pixelsOf(image, CV_32FC1);
  EXPECT_EQ(std::memcmp(pixels.ptr(7), depths.data(), sizeof(depths)), 0);
  EXPECT_TRUE(std::isnan(pixels.at<float>(7, 4)));
  EXPECT_TRUE(std::isnan(pixels.at<float>(479, 639)));
}

TEST_F(RosBag, AsksForDepthOnlyWhereItIsWanted) {
  EXPECT_TRUE(load({}).requirements().depth);
  EXPECT_FALSE(load({{"depth", false}}).requirements().depth);
}

TEST_F(RosBag, HasNoDepthTopicsWithoutDepth) {
  load({{"depth", false}});
  Scene only = timed(0, {});
  only.depth = cv::Mat();
  runAll({only});
  EXPECT_EQ(counts().size(), 5U);
  EXPECT_EQ(counts().count("/camera/depth/image_rect_raw"), 0U);
}

TEST_F(RosBag, DescribesAPinholeCamera) {
  load({});
  runAll({timed(0, {})});
  const auto info = onlyMessage<sensor_msgs::CameraInfo>("/camera/camera_info");
  EXPECT_EQ(info.header.frame_id, "synthetic/camera/optical_link");
  EXPECT_EQ(info.header.stamp, ros::Time(1, 123456789));
  EXPECT_EQ(info.width, 640U);
  EXPECT_EQ(info.height, 480U);
  EXPECT_EQ(info.distortion_model, "plumb_bob");
  EXPECT_THAT(info.D, ElementsAre(0.0, 0.0, 0.0, 0.0, 0.0));
  EXPECT_THAT(info.K, ElementsAre(500.0, 0.0, 320.0, 0.0, 500.0, 240.0, 0.0, 0.0, 1.0));
  EXPECT_THAT(info.R, ElementsAre(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0));
  EXPECT_THAT(info.P,
              ElementsAre(500.0, 0.0, 320.0, 0.0, 0.0, 500.0, 240.0, 0.0, 0.0, 0.0, 1.0, 0.0));
}

TEST_F(RosBag, TellsTheIntrinsicsThatAnImageHas) {
  dataset_.cameras[0].intrinsics_vary = true;
  load({});
  runAll({zoomed(timed(0, {}), 700.0)});
  for (const char* topic : {"/camera/camera_info", "/camera/depth/camera_info"}) {
    const auto info = onlyMessage<sensor_msgs::CameraInfo>(topic);
    EXPECT_THAT(info.K, ElementsAre(700.0, 0.0, 320.0, 0.0, 700.0, 240.0, 0.0, 0.0, 1.0));
  }
}

TEST_F(RosBag, GivesTheLensItsCoefficients) {
  struct Case {
    std::string name;
    std::vector<double> coefficients;
  };
  for (const Case& each :
       {Case{"plumb_bob", {0.01, 0.02, 0.003, 0.004, 0.05}},
        Case{"rational_polynomial", {0.01, 0.02, 0.003, 0.004, 0.05, 0.06, 0.07, 0.08}},
        Case{"equidistant", {0.01, 0.02, 0.003, 0.004}}, Case{"double_sphere", {-0.2, 0.6}}}) {
    clear();
    const CameraModel lens(640, 480, {500.0, 500.0, 320.0, 240.0}, 0.05, 100.0,
                           makeDistortion(each.name, each.coefficients));
    dataset_.cameras.front().model = lens;
    load({});
    Scene only = timed(0, {});
    only.camera = lens;
    runAll({only});
    const auto info = onlyMessage<sensor_msgs::CameraInfo>("/camera/camera_info");
    EXPECT_EQ(info.distortion_model, each.name);
    EXPECT_EQ(info.D, each.coefficients) << each.name;
    EXPECT_EQ(counts().count("/camera/depth/image_raw"), 1U) << "it is not rectified";
  }
}

TEST_F(RosBag, GivesPosesOfCameraAndObjectsFramesOfTheirOwn) {
  load({});
  SceneObject object = seen("a", {10, 20, 30, 40});
  object.X_GO = turned({1.5, -2.5, 0.125});
  Scene only = timed(0, {object});
  only.X_GC.translation() = Eigen::Vector3d(0.1, 0.2, 0.3);
  runAll({only});
  const auto transforms = onlyMessage<tf2_msgs::TFMessage>("/tf").transforms;
  ASSERT_EQ(transforms.size(), 2U);
  EXPECT_EQ(transforms[0].child_frame_id, "synthetic/camera/optical_link");
  EXPECT_EQ(transforms[0].transform.translation.y, 0.2);
  EXPECT_EQ(transforms[0].transform.rotation.w, 1.0);
  EXPECT_EQ(transforms[1].child_frame_id, "synthetic/a");
  EXPECT_EQ(transforms[1].header.frame_id, "map");
  EXPECT_EQ(transforms[1].header.stamp, ros::Time(1, 123456789));
  EXPECT_EQ(transforms[1].transform.translation.x, 1.5);
  EXPECT_EQ(transforms[1].transform.translation.y, -2.5);
  EXPECT_EQ(transforms[1].transform.translation.z, 0.125);
  EXPECT_NEAR(transforms[1].transform.rotation.z, std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(transforms[1].transform.rotation.w, std::sqrt(0.5), 1e-15);
}

TEST_F(RosBag, TakesTheRecordingsFramesWithoutAPrefix) {
  dataset_.global_frame = "/map";
  load({{"frame_prefix", ""}});
  runAll({timed(0, {seen("map", {10, 20, 30, 40})})});
  const auto transforms = onlyMessage<tf2_msgs::TFMessage>("/tf").transforms;
  ASSERT_EQ(transforms.size(), 1U) << "a frame in itself says nothing";
  EXPECT_EQ(transforms[0].header.frame_id, "map");
  EXPECT_EQ(transforms[0].child_frame_id, "camera/optical_link");
}

TEST_F(RosBag, DrawsABoxRoundEachLabelledObject) {
  load({});
  SceneObject object = seen("a", {10, 20, 30, 40});
  object.cuboid_O = {{-1.0, -0.5, 0.0}, {3.0, 0.5, 1.0}};  // its centre: (1, 0, 0.5)
  object.X_GO = turned({10.0, 20.0, 0.0});
  SceneObject hidden = seen("b", {10, 20, 30, 40});
  hidden.pixels.visible = 0;
  SceneObject dropped = seen("c", {10, 20, 30, 40});
  dropped.dropped = true;
  runAll({timed(0, {object, hidden, dropped})});
  const auto markers = onlyMessage<visualization_msgs::MarkerArray>("/camera/objects").markers;
  ASSERT_EQ(markers.size(), 3U);
  EXPECT_EQ(markers[0].action, Marker::DELETEALL);
  const Marker& box = markers[1];
  EXPECT_EQ(box.type, Marker::CUBE);
  EXPECT_EQ(box.header.frame_id, "map");
  EXPECT_EQ(box.ns, "a_class");
  EXPECT_EQ(box.id, 1);
  EXPECT_NEAR(box.pose.position.x, 10.0, 1e-12);  // x goes to y
  EXPECT_NEAR(box.pose.position.y, 21.0, 1e-12);
  EXPECT_NEAR(box.pose.position.z, 0.5, 1e-12);
  EXPECT_NEAR(box.pose.orientation.z, std::sqrt(0.5), 1e-15);
  EXPECT_EQ(box.scale.x, 4.0);
  EXPECT_EQ(box.scale.y, 1.0);
  EXPECT_EQ(box.scale.z, 1.0);
  EXPECT_EQ(markers[2].type, Marker::TEXT_VIEW_FACING);
  EXPECT_EQ(markers[2].text, "a");
  EXPECT_GT(markers[2].pose.position.z, 1.0);
}

TEST_F(RosBag, GivesEachCameraTopicsAndTellsObjectsPosesOnceAnInstant) {
  dataset_.cameras = {{"front.left", "f", camera()}, {"front-left", "g", camera()}};
  load({});
  std::vector<Scene> scenes;
  for (const std::size_t i : {0U, 1U}) {
    Scene each = timed(static_cast<std::int64_t>(i), {seen("a", {10, 20, 30, 40})});
    each.camera_index = i;
    each.name = dataset_.cameras[i].name + "/00000000";
    each.stamp = std::chrono::seconds(5);
    scenes.push_back(std::move(each));
  }
  runAll(scenes);
  EXPECT_THAT(counts(), IsSupersetOf({Pair("/front_left/image_raw", 1),
                                      Pair("/front_left_2/image_raw", 1), Pair("/tf", 2)}));
  std::map<std::string, int> frames;
  for (const auto& message : messages<tf2_msgs::TFMessage>("/tf")) {
    for (const auto& transform : message.transforms) ++frames[transform.child_frame_id];
  }
  EXPECT_THAT(frames, UnorderedElementsAre(Pair("synthetic/a", 1), Pair("synthetic/f", 1),
                                           Pair("synthetic/g", 1)));
}

TEST_F(RosBag, TellsTheFrameThatTwoCamerasShareOnce) {
  dataset_.cameras = {{"left", "f", camera()}, {"right", "f", camera()}};
  load({{"depth", false}});
  Scene left = timed(0, {});
  left.name = "left/00000000";
  Scene right = timed(1, {});
  right.name = "right/00000000";
  right.camera_index = 1;
  runAll({left, right});
  EXPECT_EQ(onlyMessage<tf2_msgs::TFMessage>("/tf").transforms.size(), 1U);
  EXPECT_EQ(onlyMessage<sensor_msgs::CameraInfo>("/right/camera_info").header.frame_id,
            "synthetic/f");
}

TEST_F(RosBag, PutsTopicsBelowAPrefix) {
  load({{"topic_prefix", "/synthetic/"}, {"depth", false}});
  runAll({timed(0, {})});
  EXPECT_THAT(counts(),
              AllOf(Contains(Pair("/synthetic/camera/image_raw", 1)), Contains(Pair("/tf", 1))));
}

TEST_F(RosBag, IsNamedAsAsked) {
  load({{"file", "hall.bag"}});
  runAll({timed(0, {})});
  EXPECT_TRUE(std::filesystem::exists(folder() + "hall.bag"));
}

TEST_F(RosBag, HasTheSameBytesEachTimeWhateverTheCompression) {
  std::map<std::string, std::string> first;
  for (int run = 0; run < 2; ++run) {
    for (const char* compression : {"none", "lz4", "bz2"}) {
      clear();
      load({{"compression", compression}, {"depth", false}});
      runAll({timed(0, {seen("a", {10, 20, 30, 40})})});
      const std::string bytes = test::readFile(bagFile());
      EXPECT_EQ(counts().at("/camera/image_raw"), 1);
      EXPECT_EQ(first.emplace(compression, bytes).first->second, bytes) << compression;
    }
  }
  EXPECT_LT(first["lz4"].size(), first["none"].size() / 2);
  EXPECT_LT(first["bz2"].size(), first["none"].size() / 2);
}

TEST_F(RosBag, NamesNobodyThatPublished) {
  load({});
  runAll({timed(0, {})});
  const rosbag::Bag bag(bagFile());
  rosbag::View view(bag);
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    EXPECT_EQ(connection->header->count("callerid"), 0U);
    EXPECT_EQ(connection->header->count("message_definition"), 1U);
  }
}

TEST_F(RosBag, RefusesATimeThatRosDoesNotHave) {
  const output::WriterHost& host = load({});
  Scene early = timed(0, {});
  early.stamp = Stamp{0};
  EXPECT_THROW((void)host.writeScene(early), Error);
}

TEST_F(RosBag, TellsWrongSettings) {
  load({{"file", "../a.bag"}, {"compression", "zip"}, {"topic_prefix", "a b"}});
  EXPECT_THAT(parameters_.errors(),
              ElementsAre(HasSubstr("w/file: found '../a.bag'; it should be"),
                          HasSubstr("w/compression: found 'zip'; it should be none, lz4 or bz2"),
                          HasSubstr("w/topic_prefix: found 'a b'; ")));
}

TEST_F(RosBag, RefusesANameWithAControlCharacter) {
  load({{"file", "a\nb.bag"}});
  EXPECT_THAT(parameters_.errors(), ElementsAre(HasSubstr("w/file: found 'a\nb.bag'")));
}

TEST_F(RosBag, TellsOfAFullDiskAndLeavesNoBag) {
  load({{"depth", false}});
  // A limit on file size stands in for a full disk: only the bag is larger.
  rlimit old_limit{};
  getrlimit(RLIMIT_FSIZE, &old_limit);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit = old_limit;
  limit.rlim_cur = 500000;
  setrlimit(RLIMIT_FSIZE, &limit);
  std::string failure = "no error";
  try {
    runAll({timed(0, {}), timed(1, {})});
  } catch (const Error& error) {
    failure = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &old_limit);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_THAT(failure, HasSubstr("writer 'w': the bag 'dataset.bag' cannot be written"));
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    EXPECT_TRUE(entry.is_directory()) << entry.path();
  }
}

}  // namespace ros_bag_writer_test
}  // namespace synthetic_dataset
