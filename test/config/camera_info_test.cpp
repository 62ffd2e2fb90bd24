#include "config/camera_info.h"

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::config {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr char kCalibration[] = R"(image_width: 640
image_height: 480
camera_name: front
camera_matrix:
  rows: 3
  cols: 3
  data: [554.5, 0, 320.5, 0, 555.5, 240.5, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}
projection_matrix:
  rows: 3
  cols: 4
  data: [500.0, 0, 310.0, 0, 0, 501.0, 230.0, 0, 0, 0, 1, 0]
)";

class CameraInfo : public ::testing::Test {
 protected:
  CameraModel read(const std::string& text, bool rectified = false) {
    return readCameraInfo(folder.write("camera.yaml", text).string(), rectified, 0.1, 50.0);
  }

  static std::string with(const std::string& old_text, const std::string& new_text) {
    std::string text = kCalibration;
    return text.replace(text.find(old_text), old_text.size(), new_text);
  }

  test::TemporaryFolder folder;
};

TEST_F(CameraInfo, IsReadAsCameraCalibrationWritesIt) {
  const CameraModel camera = read(kCalibration);
  EXPECT_EQ(camera.width(), 640);
  EXPECT_EQ(camera.height(), 480);
  EXPECT_EQ(camera.intrinsics().fx, 554.5);
  EXPECT_EQ(camera.intrinsics().fy, 555.5);
  EXPECT_EQ(camera.intrinsics().cx, 320.5);
  EXPECT_EQ(camera.intrinsics().cy, 240.5);
  EXPECT_EQ(camera.near(), 0.1);
}

TEST_F(CameraInfo, IsReadAsAnEchoedMessage) {
  const CameraModel camera = read(
      "width: 320\nheight: 240\nK: [100.0, 0.0, 160.0, 0.0, 101.0, 120.0, 0.0, 0.0, 1.0]\n"
      "D: [0.0, 0.0, 0.0, 0.0, 0.0]\n");
  EXPECT_EQ(camera.width(), 320);
  EXPECT_EQ(camera.intrinsics().fy, 101.0);
}

TEST_F(CameraInfo, OfTheRectifiedCameraIsTheProjectionMatrix) {
  const CameraModel camera =
      read(with("data: [0, 0, 0, 0, 0]", "data: [-0.3, 0.1, 0, 0, 0]"), true);
  EXPECT_EQ(camera.intrinsics().fx, 500.0);
  EXPECT_EQ(camera.intrinsics().cy, 230.0);
}

TEST_F(CameraInfo, RefusesALensDistortionAndSaysWhatToDo) {
  EXPECT_THAT([&] { read(with("data: [0, 0, 0, 0, 0]", "data: [-0.3, 0.1, 0, 0, 0]")); },
              ThrowsMessage<Error>(HasSubstr("camera/rectified: true")));
}

TEST_F(CameraInfo, NamesEverythingThatIsMissing) {
  EXPECT_THAT([&] { read("image_width: 640\n"); },
              ThrowsMessage<Error>(AllOf(HasSubstr("camera.yaml: image_height: required"),
                                         HasSubstr("camera_matrix/data: required"))));
}

TEST_F(CameraInfo, RefusesAMatrixOfTheWrongSize) {
  EXPECT_THAT([&] { read(with(", 0, 0, 1]", "]")); },
              ThrowsMessage<Error>(HasSubstr("camera_matrix: found 6 numbers; it should be 9")));
}

TEST_F(CameraInfo, RefusesASkew) {
  EXPECT_THAT([&] { read(with("[554.5, 0,", "[554.5, 2,")); },
              ThrowsMessage<Error>(HasSubstr("skew")));
}

TEST_F(CameraInfo, NamesTheFileOfAnImpossibleCamera) {
  EXPECT_THAT([&] { read(with("554.5", "0.0")); },
              ThrowsMessage<Error>(AllOf(HasSubstr("camera.yaml"), HasSubstr("fx"))));
}

}  // namespace
}  // namespace synthetic_dataset::config
