#include "scene/calibration/calibration_file.h"

#include <gmock/gmock.h>
#include <opencv2/calib3d.hpp>

#include "support/error_messages.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::scene {
namespace calibration_file_test {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class CalibrationFile : public ::testing::Test {
 protected:
  CalibratedCamera read(const std::string& text, const CalibrationChoice& choice = {},
                        bool rectified = false) {
    return readCalibration(folder.write("camera", text).string(), choice, {rectified, 0.05, 90.0});
  }

  std::vector<std::string> errorsOf(const std::string& text, const CalibrationChoice& choice = {}) {
    return test::messagesOf([&] { (void)read(text, choice); });
  }

  test::TemporaryFolder folder;
};

/// Expects the camera to show points where OpenCV does with the same numbers.
void expectAsOpenCv(const CameraModel& camera, const cv::Matx33d& K, const std::vector<double>& D) {
  const std::vector<cv::Point3d> points = {{0.1, -0.2, 1.0}, {-0.4, 0.3, 2.0}, {0.5, 0.1, 1.5}};
  std::vector<cv::Point2d> pixels;
  if (camera.distortion().model == DistortionModel::kEquidistant) {
    cv::fisheye::projectPoints(points, pixels, cv::Vec3d(), cv::Vec3d(), K, D);
  } else {
    cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), K, D, pixels);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto pixel = camera.project({points[i].x, points[i].y, points[i].z});
    ASSERT_TRUE(pixel) << i;
    EXPECT_NEAR(pixel->x(), pixels[i].x, 1e-6);
    EXPECT_NEAR(pixel->y(), pixels[i].y, 1e-6);
  }
}

TEST_F(CalibrationFile, OfRos2HasItsNamesInSmallLetters) {
  const CalibratedCamera camera = read(
      "header: {stamp: {sec: 1, nanosec: 2}, frame_id: oak}\nheight: 250\nwidth: 260\n"
      "distortion_model: rational_polynomial\n"
      "d:\n- -0.3\n- 1e-02\n- 3.4e-04\n- -9.4e-05\n- 0.02\n- -0.1\n- 0.01\n- 0.02\n"
      "k: [202.0, 0.0, 124.0, 0.0, 203.0, 127.0, 0.0, 0.0, 1.0]\n"
      "r: [1, 0, 0, 0, 1, 0, 0, 0, 1]\np: [202, 0, 124, 0, 0, 203, 127, 0, 0, 0, 1, 0]\n---\n");
  EXPECT_EQ(camera.model.width(), 260);
  EXPECT_EQ(camera.frame, "oak");
  expectAsOpenCv(camera.model, {202, 0, 124, 0, 203, 127, 0, 0, 1},
                 {-0.3, 0.01, 3.4e-4, -9.4e-5, 0.02, -0.1, 0.01, 0.02});
}

constexpr char kOst[] =
    "# oST version 5.0 parameters\n\n\n[image]\n\nwidth\n640\n\nheight\n480\n\n[narrow_stereo]\n\n"
    "camera matrix\n906.9 0.000000 331.4\n0.0 899.5 176.2\n0.0 0.0 1.0\n\n"
    "distortion\n0.36 -1.41 -0.013 -0.005 0.0\n\n"
    "rectification\n1 0 0\n0 1 0\n0 0 1\n\n"
    "projection\n932.2 0 329.7 0\n0 919.4 172.9 0\n0 0 1 0\n\n";

TEST_F(CalibrationFile, OfCameraCalibrationMayBeItsOstTxt) {
  const CameraModel camera = read(kOst).model;
  EXPECT_EQ(camera.width(), 640);
  EXPECT_EQ(camera.height(), 480);
  expectAsOpenCv(camera, {906.9, 0, 331.4, 0, 899.5, 176.2, 0, 0, 1},
                 {0.36, -1.41, -0.013, -0.005, 0.0});
  EXPECT_EQ(read(kOst, {}, true).model.intrinsics().fx, 932.2);
}

TEST_F(CalibrationFile, OfAnOstTxtNamesTheLineThatIsWrong) {
  EXPECT_THAT(errorsOf("[image]\n\n640\n"),
              ElementsAre(HasSubstr("line 3: found numbers without a name")));
  EXPECT_THAT(errorsOf("[image]\nwidth\n640\nheight\n480\n"),
              ElementsAre(HasSubstr("found no camera")));
}

std::string kalibr(const std::string& model, const std::string& intrinsics,
                   const std::string& distortion_model, const std::string& coefficients) {
  return "  camera_model: " + model + "\n  distortion_coeffs: " + coefficients +
         "\n  distortion_model: " + distortion_model + "\n  intrinsics: " + intrinsics +
         "\n  resolution: [752, 480]\n  rostopic: /cam0/image_raw\n";
}

TEST_F(CalibrationFile, OfKalibrMayBeAPinholeWithEitherDistortion) {
  const CameraModel radtan = read("cam0:\n" + kalibr("pinhole", "[458.9, 457.5, 367.0, 249.3]",
                                                     "radtan", "[-0.28, 0.07, 2e-4, -1e-4]"))
                                 .model;
  EXPECT_EQ(radtan.width(), 752);
  expectAsOpenCv(radtan, {458.9, 0, 367.0, 0, 457.5, 249.3, 0, 0, 1}, {-0.28, 0.07, 2e-4, -1e-4});
  const CameraModel fisheye = read("cam0:\n" + kalibr("pinhole", "[461.4, 460.1, 356.3, 231.1]",
                                                      "equidistant", "[-0.01, 0.02, -0.03, 0.01]"))
                                  .model;
  EXPECT_EQ(fisheye.distortion().model, DistortionModel::kEquidistant);
  expectAsOpenCv(fisheye, {461.4, 0, 356.3, 0, 460.1, 231.1, 0, 0, 1}, {-0.01, 0.02, -0.03, 0.01});
}

TEST_F(CalibrationFile, OfKalibrMayBeOmnidirectionalOrADoubleSphere) {
  const CameraModel omni = read("cam0:\n" + kalibr("omni", "[1.2, 458.9, 457.5, 367.0, 249.3]",
                                                   "radtan", "[-0.2, 0.1, 0.001, 0.002]"))
                               .model;
  EXPECT_EQ(omni.distortion().model, DistortionModel::kOmnidirectional);
  EXPECT_THAT(coefficientsOf(omni.distortion()), ElementsAre(1.2, -0.2, 0.1, 0.001, 0.002));
  EXPECT_EQ(omni.intrinsics().fx, 458.9);
  const CameraModel sphere =
      read("cam0:\n" + kalibr("ds", "[-0.2, 0.6, 360.0, 361.0, 367.0, 249.3]", "none", "[]")).model;
  EXPECT_EQ(sphere.distortion().model, DistortionModel::kDoubleSphere);
  EXPECT_THAT(coefficientsOf(sphere.distortion()), ElementsAre(-0.2, 0.6));
  EXPECT_EQ(sphere.intrinsics().fy, 361.0);
}

TEST_F(CalibrationFile, OfKalibrWithAModelThatIsNotDrawnIsRefusedByItsName) {
  EXPECT_THAT(errorsOf("cam0:\n" + kalibr("eucm", "[0.6, 1.1, 360, 361, 367, 249]", "none", "[]")),
              ElementsAre(AllOf(HasSubstr("cam0: a Kalibr camchain with model eucm"),
                                HasSubstr("not drawn"))));
  EXPECT_THAT(errorsOf("cam0:\n" + kalibr("pinhole", "[360, 361, 367, 249]", "fov", "[0.9]")),
              ElementsAre(AllOf(HasSubstr("'fov'"), HasSubstr("not drawn"))));
  EXPECT_THAT(errorsOf("cam0:\n" + kalibr("pinhole", "[360, 361, 367]", "none", "[]")),
              ElementsAre(HasSubstr("intrinsics: found 3 numbers")));
}

TEST_F(CalibrationFile, WithSeveralCamerasNeedsOneToBeNamed) {
  const std::string chain =
      "cam0:\n" + kalibr("pinhole", "[400, 401, 367, 249]", "none", "[]") + "cam1:\n" +
      kalibr("pinhole", "[500, 501, 367, 249]", "none", "[]") +
      "  T_cn_cnm1:\n  - [1, 0, 0, -0.11]\n  - [0, 1, 0, 0.02]\n  - [0, 0, 1, 0]\n"
      "  - [0, 0, 0, 1]\n";
  EXPECT_THAT(errorsOf(chain),
              ElementsAre(HasSubstr("has the cameras cam0, cam1; info_camera should name one")));
  EXPECT_EQ(read(chain, {"cam1", {}}).model.intrinsics().fx, 500.0);
  EXPECT_THAT(errorsOf(chain, {"cam2", {}}),
              ElementsAre(HasSubstr("info_camera: found 'cam2'; the file has the cameras")));
  const CalibratedCamera second = read(chain, {"cam1", "cam0"});
  EXPECT_LT((second.X_FC.translation() - Eigen::Vector3d(0.11, -0.02, 0.0)).norm(), 1e-12);
}

TEST_F(CalibrationFile, OfCamodocalHasItsLensByItsOwnNames) {
  const std::string head =
      "%YAML:1.0\n---\ncamera_name: camera\nimage_width: 752\nimage_height: 480\n";
  const CameraModel mei =
      read(head +
           "model_type: MEI\nmirror_parameters:\n   xi: 1.5\ndistortion_parameters:\n   k1: -0.1\n"
           "   k2: 0.2\n   p1: 0.001\n   p2: 0.002\nprojection_parameters:\n   gamma1: 800.5\n"
           "   gamma2: 801.\n   u0: 367.\n   v0: 249.\n")
          .model;
  EXPECT_EQ(mei.distortion().model, DistortionModel::kOmnidirectional);
  EXPECT_THAT(coefficientsOf(mei.distortion()), ElementsAre(1.5, -0.1, 0.2, 0.001, 0.002));
  EXPECT_EQ(mei.intrinsics().fx, 800.5);
  const CameraModel fisheye =
      read(head +
           "model_type: KANNALA_BRANDT\nprojection_parameters:\n   k2: -0.01\n   k3: 0.02\n"
           "   k4: -0.03\n   k5: 0.01\n   mu: 461.4\n   mv: 460.1\n   u0: 356.3\n   v0: 231.1\n")
          .model;
  expectAsOpenCv(fisheye, {461.4, 0, 356.3, 0, 460.1, 231.1, 0, 0, 1}, {-0.01, 0.02, -0.03, 0.01});
  EXPECT_THAT(errorsOf(head + "model_type: SCARAMUZZA\nprojection_parameters: {}\n"),
              ElementsAre(HasSubstr("camodocal with model_type SCARAMUZZA, which is not drawn")));
}

constexpr char kStorage[] =
    "%YAML:1.0\n---\n"
    "M: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
    "   data: [ 2.7467e+02, 0., 2.8226e+02, 0.,\n       2.7477e+02, 2.4563e+02, 0., 0., 1. ]\n"
    "D: !!opencv-matrix\n   rows: 4\n   cols: 1\n   dt: d\n"
    "   data: [ 2.92e-03, 1.55e-03, 0., 0. ]\n"
    "width: 640\nheight: 480\ndistortion_model: fisheye\n"
    "calibration_time: \"2023-07-19 20:18:11\"\n";

TEST_F(CalibrationFile, OfOpenCvIsReadAsFileStorageReadsIt) {
  expectAsOpenCv(read(kStorage).model, {274.67, 0, 282.26, 0, 274.77, 245.63, 0, 0, 1},
                 {2.92e-3, 1.55e-3, 0.0, 0.0});
  const CameraModel xml =
      read(
          "<?xml version=\"1.0\"?>\n<opencv_storage>\n<image_Width>640</image_Width>"
          "<image_Height>480</image_Height>\n<Camera_Matrix "
          "type_id=\"opencv-matrix\"><rows>3</rows>"
          "<cols>3</cols><dt>d</dt><data>500 0 320 0 510 240 0 0 1</data></Camera_Matrix>\n"
          "<Distortion_Coefficients type_id=\"opencv-matrix\"><rows>5</rows><cols>1</cols>"
          "<dt>d</dt><data>0.1 -0.2 0.01 0.02 -0.001</data></Distortion_Coefficients>\n"
          "</opencv_storage>\n")
          .model;
  EXPECT_EQ(xml.height(), 480);
  expectAsOpenCv(xml, {500, 0, 320, 0, 510, 240, 0, 0, 1}, {0.1, -0.2, 0.01, 0.02, -0.001});
}

TEST_F(CalibrationFile, OfOpenCvsOmnidirHasItsMirrorAndItsSkew) {
  const CalibratedCamera camera = read(
      "%YAML:1.0\n---\nimage_width: 1280\nimage_height: 800\n"
      "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
      "   data: [ 800., 4., 640., 0., 810., 400., 0., 0., 1. ]\n"
      "distortion_coefficients: !!opencv-matrix\n   rows: 1\n   cols: 4\n   dt: d\n"
      "   data: [ -0.2, 0.1, 0.001, 0.002 ]\nxi: 1.1\n");
  EXPECT_THAT(coefficientsOf(camera.model.distortion()),
              ElementsAre(1.1, -0.2, 0.1, 0.001, 0.002, 0.005));
  EXPECT_TRUE(camera.warnings.empty());
}

TEST_F(CalibrationFile, OfOpenCvMayCallItsCameraAPinholeAndBendItsPicture) {
  const std::string text =
      "%YAML:1.0\n---\ncamera_model: pinhole\nwidth: 640\nheight: 480\n"
      "K: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
      "   data: [ 500., 0., 320., 0., 510., 240., 0., 0., 1. ]\n"
      "D: !!opencv-matrix\n   rows: 1\n   cols: 5\n   dt: d\n"
      "   data: [ 0.1, -0.2, 0.01, 0.02, -0.001 ]\n";
  const cv::Matx33d K(500, 0, 320, 0, 510, 240, 0, 0, 1);
  expectAsOpenCv(read(text).model, K, {0.1, -0.2, 0.01, 0.02, -0.001});
  expectAsOpenCv(read(text + "distortion_model: radtan\n").model, K,
                 {0.1, -0.2, 0.01, 0.02, -0.001});
}

TEST_F(CalibrationFile, OfOpenCvMayBeThatOfAStereoPair) {
  const std::string matrix = ": !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ ";
  const std::string pair = "%YAML:1.0\nimage_size: [ 640, 480 ]\nM1" + matrix +
                           "500., 0., 320., 0., 500., 240., 0., 0., 1. ]\nM2" + matrix +
                           "600., 0., 320., 0., 600., 240., 0., 0., 1. ]\n";
  EXPECT_THAT(errorsOf(pair), ElementsAre(HasSubstr("has the cameras 1, 2")));
  EXPECT_EQ(read(pair, {"2", {}}).model.intrinsics().fx, 600.0);
}

TEST_F(CalibrationFile, ThatOpenCvCannotReadSaysSo) {
  EXPECT_THAT(errorsOf("%YAML:1.0\n---\nM: [ 1, 2\n"),
              ElementsAre(HasSubstr("OpenCV's FileStorage cannot read it")));
  EXPECT_THAT(errorsOf("<?xml version=\"1.0\"?>\n<opencv_storage><a>1</a></opencv_storage>\n"),
              ElementsAre(HasSubstr("found no camera matrix")));
}

/// OpenCV's own parsers would end the program.
TEST_F(CalibrationFile, OfOpenCvThatNestsWithoutBoundIsRefused) {
  const auto repeated = [](const std::string& part, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += part;
    return text;
  };
  const std::string xml = "<?xml version=\"1.0\"?>\n<opencv_storage>\n";
  EXPECT_THAT(errorsOf(xml + repeated("<a>", 50000) + "1" + repeated("</a>", 50000)),
              ElementsAre(HasSubstr("OpenCV's FileStorage")));
  EXPECT_THAT(
      errorsOf(xml + repeated("<a>", 450) + "1" + repeated("</a>", 450) + "</opencv_storage>"),
      ElementsAre(HasSubstr("nested deeper than 400 levels")));
  EXPECT_THAT(errorsOf("%YAML:1.0\n---\ncamera_matrix: " + repeated("[", 50000)),
              ElementsAre(HasSubstr("camera")));
}

TEST_F(CalibrationFile, IsFoundBelowAGroupAndLacksNothingButItsSize) {
  const std::string group =
      "fisheye:\n  camera_matrix: {rows: 3, cols: 3, data: [900, 0, 640, 0, 900, 360, 0, 0, 1]}\n"
      "  distortion_model: fisheye\n  distortion_coefficients: {data: [0.01, 0, 0, 0]}\n";
  EXPECT_THAT(errorsOf(group),
              ElementsAre(AllOf(HasSubstr("fisheye: image_width: required, and image_height"))));
  const CameraModel camera = read(group + "  image_width: 1280\n  image_height: 720\n").model;
  EXPECT_EQ(camera.distortion().model, DistortionModel::kEquidistant);
}

TEST_F(CalibrationFile, OfAnotherKindNamesTheKindsThatAreRead) {
  EXPECT_THAT(
      errorsOf("gains: {p: {x: 1.0}}\n"),
      ElementsAre(AllOf(HasSubstr("not a known kind of calibration"), HasSubstr("Kalibr"))));
}

}  // namespace calibration_file_test
}  // namespace synthetic_dataset::scene
