#include "scene/calibration/camera_info.h"

#include <gmock/gmock.h>

#include "scene/calibration/calibration_file.h"
#include "support/error_messages.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::scene {
namespace camera_info_test {

using ::testing::AllOf;
using ::testing::HasSubstr;

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
    return readCalibration(folder.write("camera.yaml", text).string(), {}, {rectified, 0.1, 50.0})
        .model;
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

constexpr char kZeros[] = "data: [0, 0, 0, 0, 0]";
constexpr char kModel[] = "plumb_bob";

TEST_F(CameraInfo, WithoutDistortionHasNone) {
  EXPECT_EQ(read(kCalibration).distortion().model, DistortionModel::kNone);
}

TEST_F(CameraInfo, HasTheCoefficientsInTheOrderOfTheFile) {
  const Distortion distortion =
      read(with(kZeros, "data: [-0.3, 0.1, 0.001, 0.002, 0.05]")).distortion();
  EXPECT_EQ(distortion.model, DistortionModel::kPlumbBob);
  EXPECT_THAT(distortion.coefficients,
              testing::ElementsAre(-0.3, 0.1, 0.001, 0.002, 0.05, 0, 0, 0, 0, 0, 0, 0, 0, 0));
}

TEST_F(CameraInfo, MayLeaveOutK3AndMayEndInZeros) {
  EXPECT_EQ(read(with(kZeros, "data: [-0.3, 0.1, 0, 0]")).distortion().model,
            DistortionModel::kPlumbBob);
  EXPECT_EQ(read(with(kZeros, "data: [-0.3, 0.1, 0, 0, 0.1, 0, 0, 0]")).distortion().model,
            DistortionModel::kPlumbBob);
}

class CameraInfoOfModel : public CameraInfo {
 protected:
  Distortion distortionOf(const std::string& model, const std::string& numbers) {
    CameraInfoNumbers info;
    info.width = 640;
    info.height = 480;
    info.K = {500, 0, 320, 0, 500, 240, 0, 0, 1};
    info.distortion_model = model;
    for (std::size_t at = 0; at < numbers.size();) {
      std::size_t used = 0;
      info.D.push_back(std::stod(numbers.substr(at), &used));
      at += used;
    }
    return cameraFrom(info, {false, 0.1, 50.0}).model.distortion();
  }
};

TEST_F(CameraInfoOfModel, KnowsTheModelsOfRos) {
  EXPECT_EQ(distortionOf("rational_polynomial", "1 2 0 0 5 6 7 8").coefficients[7], 8.0);
  EXPECT_EQ(distortionOf("rational_polynomial", "1 2 0 0 5 6 7 8 0 0 0 0").model,
            DistortionModel::kRationalPolynomial);
  EXPECT_EQ(distortionOf("equidistant", "0.1 0 0 0").model, DistortionModel::kEquidistant);
  EXPECT_EQ(distortionOf("fisheye", "0.1 0 0 0").model, DistortionModel::kEquidistant);
}

TEST_F(CameraInfoOfModel, KeepsAFisheyeWithoutCoefficientsAFisheye) {
  EXPECT_EQ(distortionOf("equidistant", "0 0 0 0").model, DistortionModel::kEquidistant);
}

TEST_F(CameraInfoOfModel, MayHaveAThinPrismAndATiltedSensor) {
  EXPECT_EQ(distortionOf("rational_polynomial", "1 2 0 0 5 6 7 8 0.1 0 0 0").coefficients[8], 0.1);
  EXPECT_EQ(distortionOf("rational_polynomial", "1 2 0 0 5 6 7 8 0 0 0 0 0.1 0").coefficients[12],
            0.1);
}

TEST_F(CameraInfoOfModel, RefusesACountThatIsNotTheModels) {
  EXPECT_THAT(test::messagesOf([&] { distortionOf("plumb_bob", "0.1 0.2"); }),
              testing::ElementsAre(AllOf(HasSubstr("found 2 numbers"), HasSubstr("4 or 5"))));
  EXPECT_THAT(test::messagesOf([&] { distortionOf("equidistant", "0.1 0 0 0 0.2"); }),
              testing::ElementsAre(HasSubstr("equidistant has 4")));
}

TEST_F(CameraInfo, RefusesAnUnknownModelAndNamesTheKnown) {
  std::string text = with(kModel, "flat_earth");
  text.replace(text.find(kZeros), sizeof(kZeros) - 1, "data: [0.1, 0, 0, 0, 0]");
  EXPECT_THAT(
      test::messagesOf([&] { read(text); }),
      testing::ElementsAre(AllOf(HasSubstr("camera.yaml: distortion_model: found 'flat_earth'"),
                                 HasSubstr("rational_polynomial"))));
}

TEST_F(CameraInfo, OfARegionMovesThePrincipalPoint) {
  const CameraModel camera = read(std::string(kCalibration) +
                                  "roi: {x_offset: 100, y_offset: 50, width: 320, height: 240}\n");
  EXPECT_EQ(camera.width(), 320);
  EXPECT_EQ(camera.height(), 240);
  EXPECT_EQ(camera.intrinsics().cx, 220.5);
  EXPECT_EQ(camera.intrinsics().cy, 190.5);
  EXPECT_EQ(camera.intrinsics().fx, 554.5);
}

TEST_F(CameraInfo, OfBinnedPixelsHasFewerOfThem) {
  const CameraModel camera = read(std::string(kCalibration) + "binning_x: 2\nbinning_y: 2\n");
  EXPECT_EQ(camera.width(), 320);
  EXPECT_EQ(camera.intrinsics().fx, 554.5 / 2);
  // The middle between sensor pixels 0 and 1 is the centre of image pixel 0.
  EXPECT_EQ(camera.intrinsics().cx, (320.5 - 0.5) / 2);
}

TEST_F(CameraInfo, RefusesARegionOutsideOfTheImage) {
  EXPECT_THAT(test::messagesOf(
                  [&] { read(std::string(kCalibration) + "roi: {x_offset: 600, width: 320}\n"); }),
              testing::ElementsAre(HasSubstr("camera.yaml: roi/width: found 320 px from 600")));
}

TEST_F(CameraInfo, RefusesARegionThatIsBeyondAllNumbers) {
  EXPECT_THAT(test::messagesOf([&] {
                read(std::string(kCalibration) + "roi: {x_offset: 2147483647, width: 9}\n");
              }),
              testing::ElementsAre(HasSubstr("roi/width: found 9 px from 2147483647 on")));
}

TEST_F(CameraInfo, NamesEverythingThatIsMissing) {
  EXPECT_THAT(test::messagesOf([&] { read("image_width: 640\n"); }),
              testing::ElementsAre(HasSubstr("camera.yaml: image_height: required"),
                                   HasSubstr("camera_matrix: required")));
}

TEST_F(CameraInfo, RefusesAMatrixOfTheWrongSize) {
  EXPECT_THAT(test::messagesOf([&] { read(with(", 0, 0, 1]", "]")); }),
              testing::ElementsAre(HasSubstr("camera_matrix: found 6 numbers; it should be 9")));
}

TEST_F(CameraInfo, WarnsOfASkewWhichRosDoesNotDrawEither) {
  const std::string file = folder.write("camera.yaml", with("[554.5, 0,", "[554.5, 2,")).string();
  const CalibratedCamera camera = readCalibration(file, {}, {});
  EXPECT_EQ(camera.model.intrinsics().fx, 554.5);
  EXPECT_THAT(camera.warnings, testing::ElementsAre(HasSubstr("camera_matrix: found a skew of 2")));
}

TEST_F(CameraInfo, OfAnUnknownModelWithoutCoefficientsIsAPinholeAndSaysSo) {
  const CalibratedCamera camera =
      readCalibration(folder.write("camera.yaml", with(kModel, "flat_earth")).string(), {}, {});
  EXPECT_TRUE(camera.model.isPinhole());
  EXPECT_THAT(camera.warnings, testing::ElementsAre(HasSubstr("found 'flat_earth'")));
}

TEST_F(CameraInfo, OfAnUnturnableRectificationIsRefused) {
  const std::string bad = "rectification_matrix: {data: [2, 0, 0, 0, 1, 0, 0, 0, 1]}\n";
  EXPECT_THAT(test::messagesOf([&] { read(kCalibration + bad, true); }),
              testing::ElementsAre(HasSubstr("rectification_matrix: it should be a rotation")));
}

TEST_F(CameraInfo, NamesTheFileOfAnImpossibleCamera) {
  EXPECT_THAT(test::messagesOf([&] { read(with("554.5", "0.0")); }),
              testing::ElementsAre(AllOf(HasSubstr("camera.yaml"), HasSubstr("fx"))));
}

TEST_F(CameraInfo, OfADriverWithoutACalibrationSaysWhatIsSetInstead) {
  const std::string zeros =
      with("[554.5, 0, 320.5, 0, 555.5, 240.5, 0, 0, 1]", "[0, 0, 0, 0, 0, 0, 0, 0, 0]");
  EXPECT_THAT(test::messagesOf([&] { (void)read(zeros); }),
              ::testing::ElementsAre(AllOf(HasSubstr("its focal lengths are 0"),
                                           HasSubstr("`rectified: true` takes it"))));
  EXPECT_NEAR(read(zeros, true).intrinsics().fx, 500.0, 1e-9);
}

}  // namespace camera_info_test
}  // namespace synthetic_dataset::scene
