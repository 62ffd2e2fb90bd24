#include <chrono>
#include <ostream>
#include <string>

#include <gmock/gmock.h>

#include "plugins/plugin_harness.h"
#include "plugins/readback/format.h"

/// Reads back, with each format's reader, the files that its writer makes of the same cloud.
namespace synthetic_dataset::formats {
namespace clouds_of_formats_test {

struct Case {
  std::string type;
  Value::Map settings;
  bool has_labels;
  bool is_measured;  ///< whether points are as they were measured
  bool has_boxes;
};

std::ostream& operator<<(std::ostream& stream, const Case& value) { return stream << value.type; }

class CloudsOfFormats : public PluginTest, public testing::WithParamInterface<Case> {
 protected:
  CloudsOfFormats() : PluginTest("synthetic_dataset/" + GetParam().type) {
    addLidar();
    dataset_.classes = {{0, "rover"}};
    ObjectInfo info;
    info.name = "rover";
    info.class_name = "rover";
    dataset_.objects = {info};
    dataset_.motions = {{"walk", 0, 4, 5.0}};
    dataset_.global_frame = "map";
  }

  /// A point of the world, and two of a rover to its left.
  [[nodiscard]] static Scene sceneWithCloud() {
    SceneObject rover = seen("rover", {100, 80, 50, 40});
    rover.class_name = rover.class_text = "rover";
    rover.cuboid_O = {{-0.75, -0.75, -0.75}, {0.75, 0.75, 0.75}};
    Pose X_GC = Pose::Identity();  // it looks along x, as the scanner does
    X_GC.linear() << 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0;
    rover.X_GO = makePose({1.25, 1.5, 0.5}, Eigen::Quaterniond::Identity());
    rover.X_CO = X_GC.inverse() * *rover.X_GO;
    Scene made = withCloud(scene(0, {rover}));
    made.X_GC = X_GC;
    made.stamp = Stamp(std::chrono::seconds(1));
    return made;
  }

  [[nodiscard]] LabelledCloud read(const Scene& scene) const {
    WrittenScene written{folder(), scene.name, 0, scene.stamp, {}};
    for (const auto& [path, content] : filesOf(scene)) written.files.push_back(folder() + path);
    written.settings = GetParam().settings;
    const Format* format = formatOf("synthetic_dataset/" + GetParam().type);
    const std::vector<LabelledCloud> clouds = format->clouds(written);
    EXPECT_EQ(clouds.size(), 1U);
    return clouds.empty() ? LabelledCloud() : clouds.front();
  }
};

TEST_P(CloudsOfFormats, AreTheirPointsAndObjects) {
  load(GetParam().settings);
  const Scene scene = sceneWithCloud();
  runAll({scene});
  const LabelledCloud cloud = read(scene);
  ASSERT_EQ(cloud.points.size(), 3U);
  const float ahead = GetParam().is_measured ? 1.5F : 1.25F;
  for (int i = 0; i < 3; ++i) {
    const LabelledCloud::Point& point = cloud.points[static_cast<std::size_t>(i)];
    EXPECT_LT((point.position_S - Eigen::Vector3f(ahead, static_cast<float>(i), 0.5F)).norm(), 1e-5)
        << point.position_S;
  }
  EXPECT_EQ(cloud.has_labels, GetParam().has_labels);
  EXPECT_EQ(cloud.points[0].object, 0);
  ASSERT_EQ(cloud.objects.size(), 1U);
  const auto& [number, object] = *cloud.objects.begin();
  EXPECT_EQ(cloud.points[1].object, number);
  EXPECT_EQ(cloud.points[2].object, number);
  EXPECT_EQ(object.class_name, "rover");
  EXPECT_EQ(cloud.classes.at(cloud.points[1].number), "rover");
  EXPECT_EQ(object.corners_S.has_value(), GetParam().has_boxes);
}

TEST(CloudsOfKitti, AreNoneWithoutALidar) {
  for (const char* type : {"synthetic_dataset/Kitti", "synthetic_dataset/KittiTracking"}) {
    for (const char* velodyne : {"none", "depth"}) {
      WrittenScene written;
      written.settings = {{"velodyne", velodyne}};
      EXPECT_THAT(formatOf(type)->clouds(written), testing::IsEmpty()) << type << ' ' << velodyne;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, CloudsOfFormats,
    testing::Values(Case{"Kitti", {{"velodyne", "top"}}, false, false, true},
                    Case{"KittiTracking", {{"velodyne", "top"}}, false, false, true},
                    Case{"NuScenes", {}, true, false, true}, Case{"RosBag", {}, true, true, true},
                    Case{"SemanticKitti", {}, true, false, false}),
    [](const testing::TestParamInfo<Case>& each) { return each.param.type; });

}  // namespace clouds_of_formats_test
}  // namespace synthetic_dataset::formats
