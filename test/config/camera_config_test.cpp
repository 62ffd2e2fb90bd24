#include "config/readers.h"

#include <chrono>

#include <gmock/gmock.h>

#include "base/yaml_value.h"

namespace synthetic_dataset::config {
namespace camera_config_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Reading {
  explicit Reading(const std::string& text) : root(base::parseYaml(text, "test")) {
    cameras = readCameras(root);
  }
  Parameters root;
  std::vector<scene::CameraOptions> cameras;
};

TEST(ReadCameras, OneCameraIsCalledCamera) {
  const Reading reading("camera: {info_file: /a.yaml}");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  ASSERT_EQ(reading.cameras.size(), 1U);
  EXPECT_EQ(reading.cameras[0].name, "camera");
  EXPECT_EQ(reading.cameras[0].frame, "camera/optical_link");
}

TEST(ReadCameras, TheOriginalsFrameParameterCounts) {
  const Reading reading("camera_frame_id: eye\ncamera: {info_file: /a.yaml}");
  EXPECT_EQ(reading.cameras[0].frame, "eye");
}

TEST(ReadCameras, TheFrameOfAStereoPairIsOfRectifiedCamerasAlone) {
  EXPECT_EQ(Reading("camera: {info_file: /a.yaml, rectified: true, stereo_frame: own}")
                .cameras[0]
                .stereo_frame,
            scene::StereoFrame::kOwn);
  EXPECT_THAT(Reading("camera: {info_file: /a.yaml, stereo_frame: own}").root.errors(),
              Contains(HasSubstr("camera/stereo_frame: found without `rectified: true`")));
}

TEST(ReadCameras, SeveralHaveAGroupEach) {
  const Reading reading(
      "cameras:\n"
      "  rear: {info_file: /a.yaml, near: 0.2}\n"
      "  front: {sensor: 'mast::link::eye', frame_id: eye}\n");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  ASSERT_EQ(reading.cameras.size(), 2U);
  EXPECT_EQ(reading.cameras[0].name, "front");
  EXPECT_EQ(reading.cameras[0].frame, "eye");
  EXPECT_EQ(reading.cameras[1].frame, "rear/optical_link");
  EXPECT_EQ(reading.cameras[1].near, 0.2);
  EXPECT_EQ(reading.cameras[1].far, 1000.0);
  EXPECT_EQ(reading.cameras[0].near, std::nullopt) << "the world's own";
}

TEST(ReadCameras, ARecordedCalibrationBringsItsFrame) {
  EXPECT_EQ(Reading("camera: {info_topic: /camera_info}").cameras[0].frame, std::nullopt);
}

TEST(ReadCameras, OneOfAFilesCamerasMayBeNamed) {
  const Reading reading(
      "camera: {info_file: /chain.yaml, info_camera: cam1, info_reference: cam0}");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_EQ(reading.cameras[0].info_choice.camera, "cam1");
  EXPECT_EQ(reading.cameras[0].info_choice.reference, "cam0");
  EXPECT_FALSE(reading.cameras[0].frame_is_given);
  EXPECT_THAT(Reading("camera: {info_topic: /info, info_camera: cam1}").root.errors(),
              ElementsAre(HasSubstr("without info_file")));
}

TEST(ReadCameras, EffectsAreOffUnlessSet) {
  const scene::CameraOptions camera = Reading("camera: {info_file: /a.yaml}").cameras[0];
  EXPECT_EQ(camera.shutter.exposure_time.count(), 0);
  EXPECT_EQ(camera.effects.full_well, 0.0);
  EXPECT_EQ(camera.noise_stddev, std::nullopt);
}

TEST(ReadCameras, EffectsAreRead) {
  const Reading reading(
      "camera: {info_file: /a.yaml, effects: {exposure_time: 0.02, motion_samples: 5, "
      "noise_stddev: 0.01, vignetting: 0.3, white_balance: 4000, jpeg_quality: 60}}");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  const scene::CameraOptions& camera = reading.cameras[0];
  EXPECT_EQ(camera.shutter.exposure_time, std::chrono::milliseconds(20));
  EXPECT_EQ(camera.shutter.motion_samples, 5);
  EXPECT_EQ(camera.noise_stddev, 0.01);
  EXPECT_EQ(camera.effects.vignetting, 0.3);
  EXPECT_EQ(camera.effects.white_balance, 4000.0);
  EXPECT_EQ(camera.effects.jpeg_quality, 60);
}

TEST(ReadCameras, AreMountedOnAnObject) {
  const Reading reading(
      "camera: {info_file: /a.yaml, mounted_on: alpha, pose: [1, 2, 3, 0, 0, 0, 1]}");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_EQ(reading.cameras[0].on, "alpha");
  EXPECT_EQ(reading.cameras[0].X_GC->translation(), Eigen::Vector3d(1, 2, 3));
}

TEST(ReadCameras, AreAimedAtAnObjectOrAPoint) {
  const Reading reading(
      "cameras: {a: {info_file: /a.yaml, pose: {position: [1, 2, 3], look_at: husky}}, "
      "b: {info_file: /a.yaml, pose: {position: [1, 2, 3], look_at: [4, 5, 6]}}}");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  ASSERT_TRUE(reading.cameras[0].aim && reading.cameras[1].aim);
  EXPECT_EQ(reading.cameras[0].aim->position_G, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(reading.cameras[0].aim->look_at, "husky");
  EXPECT_EQ(reading.cameras[1].aim->look_at_point_G, Eigen::Vector3d(4, 5, 6));
  EXPECT_FALSE(reading.cameras[0].X_GC);
}

TEST(ReadCameras, AreTurnedByAnglesInRadiansOrDegrees) {
  const Value settings = base::parseSettings(
      "camera: {info_file: /a.yaml, pose: {position: [1, 2, 3], rpy: [0, deg(20), rad(pi/2)]}}",
      "test");
  Parameters root(settings);
  const auto cameras = readCameras(root);
  EXPECT_THAT(root.errors(), IsEmpty());
  ASSERT_TRUE(cameras[0].aim && cameras[0].aim->rpy);
  EXPECT_NEAR(cameras[0].aim->rpy->y(), 0.3490658504, 1e-9);
  EXPECT_NEAR(cameras[0].aim->rpy->z(), 1.5707963268, 1e-9);
}

TEST(ReadCameras, AreSampledWhereTheyHaveAGroupForIt) {
  const Reading reading(
      "cameras: {a: {info_file: /a.yaml, sample: {look_at: alpha}}, "
      "b: {info_file: /a.yaml}}");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  ASSERT_TRUE(reading.cameras[0].sample);
  EXPECT_EQ(reading.cameras[0].sample->look_at, "alpha");
  EXPECT_FALSE(reading.cameras[1].sample);
}

struct BadCamera {
  std::string text;
  std::string message;
};

class BadCameras : public ::testing::TestWithParam<BadCamera> {};

TEST_P(BadCameras, AreNamedWithWhatWouldBeRight) {
  EXPECT_THAT(Reading(GetParam().text).root.errors(), ElementsAre(HasSubstr(GetParam().message)));
}

INSTANTIATE_TEST_SUITE_P(
    ReadCameras, BadCameras,
    ::testing::Values(
        BadCamera{"camera: {}", "camera: no intrinsics; camera/info_file should name"},
        BadCamera{"cameras: {a: {}}", "cameras/a: no intrinsics; cameras/a/info_file should name"},
        BadCamera{"cameras: {}", "cameras: found no camera"},
        BadCamera{"cameras: {a: {info_file: /a.yaml}}\ncamera: {info_file: /a.yaml}",
                  "cameras: found together with camera"},
        BadCamera{"cameras: {a/b: {info_file: /a.yaml}, c: {info_file: /c.yaml}}",
                  "cameras/a/b: is not a valid folder name"},
        BadCamera{"cameras: {" + std::string(81, 'a') + ": {info_file: /a.yaml}}",
                  "is not a valid folder name; up to 80 letters"},
        BadCamera{"camera: {info_file: /a.yaml, info_topic: /b}", "found both info_file and"},
        BadCamera{"camera: {info_file: /a.yaml, mounted_on: alpha, sample: {}}",
                  "camera/sample: found together with pose or mounted_on"},
        BadCamera{"camera: {info_file: /a.yaml, pose: [0, 0, 0, 0, 0, 0, 1], sample: {}}",
                  "camera/sample: found together with pose or mounted_on"},
        BadCamera{"camera: {info_file: /a.yaml, pose: {look_at: a}}",
                  "camera/pose/position: required, but missing"},
        BadCamera{"camera: {info_file: /a.yaml, pose: {position: [1, 2], look_at: a}}",
                  "camera/pose/position: found [1, 2]; it should be [x, y, z] [m]"},
        BadCamera{"camera: {info_file: /a.yaml, pose: {position: [1, 2, 3]}}",
                  "camera/pose/look_at: missing, and so is rpy"},
        BadCamera{"camera: {info_file: /a.yaml, pose: {position: [1, 2, 3], rpy: [0, 0, 0], "
                  "look_at: a}}",
                  "camera/pose/rpy: found together with look_at"},
        BadCamera{"camera: {info_file: /a.yaml, pose: {position: [1, 2, 3], rpy: [0, 0, 90]}}",
                  "each at most a turn of 6.283 rad (degrees are written deg(20))"},
        BadCamera{"camera: {info_file: /a.yaml, pose: {position: [1, 2, 3], look_at: 5}}",
                  "camera/pose/look_at: found 5"},
        BadCamera{"camera: {info_file: /a.yaml, pose: {position: [1, 2, 3], look_at: [1, 2, 3]}}",
                  "camera/pose/look_at: found the camera's own position"},
        BadCamera{"camera: {info_file: /a.yaml, pose: {position: [0, 0, 0], look_at: a}, "
                  "sample: {look_at: a}}",
                  "camera/sample: found together with pose or mounted_on"},
        BadCamera{"camera: {info_file: /a.yaml, pose: [0, 0, 0]}",
                  "or {position: [x, y, z], look_at: OBJECT or [x, y, z]}"},
        BadCamera{"camera: {info_file: /a.yaml, effects: {vignetting: 2}}",
                  "camera/effects/vignetting: found 2.0; it should be 0.0 to 1.0"},
        BadCamera{"camera: {info_file: /a.yaml, effects: {exposure_time: 0.01, motion_samples: 1}}",
                  "camera/effects/motion_samples: found 1; it should be 2 to 256"},
        BadCamera{"camera: {info_file: /a.yaml, effects: {motion_samples: 8}}",
                  "camera/effects/motion_samples: has no effect without exposure_time"},
        BadCamera{"camera: {info_file: /a.yaml, effects: {readout_bands: 8}}",
                  "camera/effects/readout_bands: has no effect without readout_time"}));

}  // namespace camera_config_test
}  // namespace synthetic_dataset::config
