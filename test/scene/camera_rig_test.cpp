#include "scene/camera_rig.h"

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "support/fake_frame_source.h"

namespace synthetic_dataset::scene {
namespace camera_rig_test {

using ::testing::ElementsAre;
using ::testing::StartsWith;

/// A camera of a world, whose file says that it sees from 0.2 to 30 m.
world::CameraSensor eye() {
  const CameraModel model(160, 120, {140, 140, 79.5, 59.5}, 0.2, 30.0);
  return {"mast::link::eye", Pose::Identity(), model, {}, "link", Pose::Identity()};
}

CameraRig rigOf(const CameraOptions& config) {
  base::Diagnostics diagnostics;
  return makeCameraRig(config, {}, {eye()}, {}, {}, test::FakeFrameSource(), diagnostics);
}

CameraOptions ofEye() {
  CameraOptions config;
  config.sensor = "mast::link::eye";
  return config;
}

TEST(CameraRig, OfTheWorldSeesAsFarAsItsFileSays) {
  const CameraModel model = rigOf(ofEye()).model;
  EXPECT_EQ(model.near(), 0.2);
  EXPECT_EQ(model.far(), 30.0);
}

TEST(CameraRig, OfTheWorldSeesAsFarAsIsSet) {
  CameraOptions config = ofEye();
  config.far = 5.0;
  const CameraModel model = rigOf(config).model;
  EXPECT_EQ(model.near(), 0.2);
  EXPECT_EQ(model.far(), 5.0);
  EXPECT_EQ(model.intrinsics(), eye().camera.intrinsics());
}

TEST(CameraRig, OfTheWorldIsRefusedWhereNothingWouldBeLeftToSee) {
  CameraOptions config = ofEye();
  config.near = 30.0;
  EXPECT_THAT(test::messagesOf([&] { (void)rigOf(config); }),
              ElementsAre(StartsWith("camera/near: found 30.0; the world's camera "
                                     "'mast::link::eye' sees from 0.2 to 30.0 m")));
}

TEST(CameraRig, FollowsItsFrameWhereThereIsOne) {
  CameraOptions config = ofEye();
  config.frame = "/mast/eye";
  const test::FakeFrameSource frames(
      {{"mast/eye", test::FakeFrameSource::fixed(Pose::Identity())}});
  base::Diagnostics diagnostics;
  const CameraRig rig = makeCameraRig(config, {}, {eye()}, {}, {}, frames, diagnostics);
  EXPECT_TRUE(rig.followsFrame());
  EXPECT_EQ(rig.followed, frames.find("mast/eye"));
}

}  // namespace camera_rig_test
}  // namespace synthetic_dataset::scene
