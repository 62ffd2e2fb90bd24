#include "base/ros_messages/scene_messages.h"

#include <gmock/gmock.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::ros_messages {
namespace scene_messages_test {

using testing::ElementsAre;
using testing::IsEmpty;

/// A scene at 1.5 s, with a visible object of 2 m at (5, 0, 0).
Scene sceneWithABox() {
  Scene scene(CameraModel(640, 480, {500.0, 510.0, 320.0, 240.0}, 0.05, 100.0));
  scene.stamp = std::chrono::milliseconds(1500);
  scene.X_GC.translation() = Eigen::Vector3d(1.0, 2.0, 3.0);
  SceneObject box;
  box.name = "/box";
  box.class_name = "crate";
  box.instance = 1;
  box.X_GO->translation() = Eigen::Vector3d(5.0, 0.0, 0.0);
  box.cuboid_O = {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}};
  box.pixels.visible = 10;
  scene.objects.push_back(box);
  return scene;
}

TEST(SceneMessages, ThatATopicShowsNeedNoBag) {
  const Scene scene = sceneWithABox();
  const SceneFrames frames("/map", "synthetic/");
  const sensor_msgs::CameraInfo info =
      cameraInfo(headerOf(scene.stamp, frames.of("/optical")), scene.camera);
  EXPECT_EQ(info.header.stamp, ros::Time(1, 500000000));
  EXPECT_EQ(info.header.frame_id, "synthetic/optical");
  EXPECT_THAT(info.K, ElementsAre(500.0, 0.0, 320.0, 0.0, 510.0, 240.0, 0.0, 0.0, 1.0));

  const auto markers = objectMarkers(scene, frames).markers;
  ASSERT_EQ(markers.size(), 3U);
  EXPECT_EQ(markers[1].header.frame_id, "map");
  EXPECT_EQ(markers[1].pose.position.x, 5.0);
  EXPECT_EQ(markers[1].scale.x, 2.0);
  EXPECT_EQ(markers[2].text, "/box");
}

TEST(SceneMessages, GiveThePosesThatTheCamerasScenesAreToGive) {
  const Scene scene = sceneWithABox();
  const SceneFrames frames("map", "synthetic/");
  const auto childrenOf = [&](const CameraFrame& camera) {
    std::vector<std::string> children;
    for (const auto& each : transforms(scene, camera, frames).transforms) {
      children.push_back(each.child_frame_id);
    }
    return children;
  };
  EXPECT_THAT(childrenOf({"optical"}), ElementsAre("synthetic/optical", "synthetic/box"));
  EXPECT_THAT(childrenOf({"optical", false, true}), ElementsAre("synthetic/box"));
  EXPECT_THAT(childrenOf({"optical", false, false}), IsEmpty());
}

TEST(SceneMessages, LeaveOutWhatIsNotInTheScene) {
  Scene scene = sceneWithABox();
  scene.objects[0].X_GO.reset();
  scene.objects[0].X_CO.reset();
  const SceneFrames frames("map", "synthetic/");
  const auto poses = transforms(scene, {"optical"}, frames).transforms;
  ASSERT_EQ(poses.size(), 1U);
  EXPECT_EQ(poses[0].child_frame_id, "synthetic/optical");
  EXPECT_EQ(objectMarkers(scene, frames).markers.size(), 1U) << "that removes those before";
}

TEST(SceneMessages, RefuseATimeThatRosDoesNotHave) {
  EXPECT_THROW((void)headerOf(Stamp{0}, "map"), Error);
  EXPECT_THROW((void)headerOf(std::chrono::hours(24 * 366 * 200), "map"), Error);
}

}  // namespace scene_messages_test
}  // namespace synthetic_dataset::ros_messages
