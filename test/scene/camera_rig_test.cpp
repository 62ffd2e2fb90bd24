#include "scene/camera_rig.h"

#include <gmock/gmock.h>

#include "support/bag_builder.h"
#include "support/error_messages.h"
#include "support/fake_frame_source.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::scene {
namespace camera_rig_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A world's camera; according to the world's file, it sees from 0.2 to 30 m.
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

/// The link of an object "rover", whose frame is "rover/base_link".
struct Mast {
  Mast() {
    link.name = "mast";
    link.X_ML = test::poseAt(0.5, 0, 1);
    rover.name = "rover";
    rover.frame = "rover/base_link";
    links.push_back({&link, world::Role::kObject, 0, "rover"});
  }

  [[nodiscard]] CameraRig rigOf(const CameraOptions& config) const {
    base::Diagnostics diagnostics;
    return makeCameraRig(config, {}, {eye()}, links, {rover}, test::FakeFrameSource(), diagnostics);
  }

  world::Link link;
  ObjectOptions rover;
  std::vector<world::LinkInstance> links;
};

TEST(CameraRig, RidesOnALinkThatTheRecordingHasNoFrameOf) {
  const test::TemporaryFolder folder;
  CameraOptions config;
  config.near = 0.1;
  config.far = 50.0;
  config.info_file =
      folder
          .write("c.yaml",
                 "image_width: 64\nimage_height: 48\ncamera_matrix: {rows: 3, cols: 3, data: [50, "
                 "0, 32, 0, 50, 24, 0, 0, 1]}\n")
          .string();
  for (const char* frame : {"rover/mast", "/rover/mast", "mast"}) {
    config.frame = frame;
    const CameraRig rig = Mast().rigOf(config);
    EXPECT_EQ(rig.link, 0U) << frame;
    EXPECT_FALSE(rig.followsFrame());
  }
  config.frame = "rover/most";
  EXPECT_THAT(test::messagesOf([&] { (void)Mast().rigOf(config); }),
              ElementsAre(HasSubstr("or a link of an object's model")));
}

TEST(CameraRig, TakesTheOnlyCameraThatIsCalledAlike) {
  CameraOptions config;
  config.sensor = "mast::base_link::eye";
  base::Diagnostics diagnostics;
  (void)makeCameraRig(config, {}, {eye()}, {}, {}, test::FakeFrameSource(), diagnostics);
  EXPECT_THAT(diagnostics.messages(base::Severity::kNote),
              ElementsAre(HasSubstr("is taken for 'mast::link::eye'")));
  config.sensor = "mast::link::ear";
  EXPECT_THAT(test::messagesOf([&] { (void)rigOf(config); }),
              ElementsAre(HasSubstr("has a camera 'mast::link::ear' (model::link::sensor); there "
                                    "are mast::link::eye")));
}

}  // namespace camera_rig_test
}  // namespace synthetic_dataset::scene
