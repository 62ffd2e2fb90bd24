#include "scene/field_of_view.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "all_at_once_run.h"
#include "base/sqlite.h"
#include "base/yaml_value.h"
#include "run/merger.h"
#include "support/writers/plugin_environment.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::run {
namespace field_of_view_test {

namespace fs = std::filesystem;
using test::AllAtOnceRun;
using test::StoppingReporter;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Files = std::map<std::string, std::string>;

constexpr double kPi = 3.14159265358979323846;
const Distortion kBent{DistortionModel::kPlumbBob, {-0.3, 0.0, 1e-3, -8e-4, 0.0}};
const CameraModel kPinhole(640, 480, {500.0, 510.0, 300.0, 250.0}, 0.05, 100.0);
const CameraModel kLens(640, 480, {500.0, 510.0, 300.0, 250.0}, 0.05, 100.0, kBent);
const CameraModel kFisheye(640, 480, {200.0, 202.0, 319.5, 239.5}, 0.05, 100.0,
                           {DistortionModel::kEquidistant, {0.02, -0.008}});

TEST(FieldOfView, IsTheAngleOfAnImageRoundTheAxis) {
  EXPECT_DOUBLE_EQ(scene::fieldOfView(kPinhole), 2.0 * std::atan(320.0 / 500.0));
  EXPECT_DOUBLE_EQ(scene::fieldOfView(kLens), scene::fieldOfView(kPinhole))
      << "without its distortion";
  EXPECT_DOUBLE_EQ(scene::fieldOfView(kFisheye), 640.0 / 200.0);
}

TEST(FieldOfView, ScalesTheFocalLengthsAlone) {
  for (const CameraModel& camera : {kPinhole, kLens, kFisheye}) {
    const CameraModel wide = scene::withFieldOfView(camera, 1.9);
    EXPECT_DOUBLE_EQ(scene::fieldOfView(wide), 1.9);
    const Intrinsics& k = camera.intrinsics();
    EXPECT_DOUBLE_EQ(wide.intrinsics().fy / wide.intrinsics().fx, k.fy / k.fx);
    EXPECT_EQ(wide.intrinsics().cx, k.cx);
    EXPECT_EQ(wide.intrinsics().cy, k.cy);
    EXPECT_EQ(wide.distortion().coefficients, camera.distortion().coefficients);
    EXPECT_EQ(wide.far(), 100.0);
  }
}

TEST(FieldOfView, OfAPinholeEndsBeforeHalfATurn) {
  EXPECT_FALSE(scene::canHaveFieldOfView(kPinhole, kPi));
  EXPECT_FALSE(scene::canHaveFieldOfView(kLens, 3.2));
  EXPECT_TRUE(scene::canHaveFieldOfView(kFisheye, 2.0 * kPi));
  EXPECT_THROW((void)scene::withFieldOfView(kPinhole, 3.2), Error);
  EXPECT_THROW((void)scene::withFieldOfView(kFisheye, 0.0), Error);
}

TEST(FieldOfView, ThatALensCannotHaveIsAnErrorOfItsCamera) {
  const auto wide = base::Distribution::uniform({1.0}, {4.0});
  const std::vector<scene::CameraRig> cameras = {{"front", kFisheye, "f"}, {"rear", kLens, "r"}};
  try {
    scene::checkFieldOfView(wide, "angle", cameras);
    FAIL();
  } catch (const ErrorList& list) {
    EXPECT_THAT(list.messages(), ElementsAre(AllOf(HasSubstr("angle: found up to 4.000 rad"),
                                                   HasSubstr("3.1"), HasSubstr("'rear'"))));
  }
  EXPECT_NO_THROW(scene::checkFieldOfView(wide, "angle", {cameras[0]}));
}

TEST(FieldOfView, AtWhichALensSeesNextToNothingIsTold) {
  const std::vector<scene::CameraRig> cameras = {{"front", kLens, "f"}, {"rear", kPinhole, "r"}};
  base::Diagnostics diagnostics;
  scene::warnOfBlackEdges(base::Distribution::constant({1.2}), "angle", cameras, diagnostics);
  EXPECT_THAT(diagnostics.all(), IsEmpty());
  scene::warnOfBlackEdges(base::Distribution::uniform({1.0}, {2.9}), "angle", cameras, diagnostics);
  EXPECT_THAT(diagnostics.messages(base::Severity::kWarning),
              ElementsAre(AllOf(HasSubstr("at 2.900 rad"), HasSubstr("'front'"))));
}

// --- Whole runs ---

Value yaml(const std::string& text) { return base::parseYaml(text, "test"); }

double numberOf(const Value& value) {
  const auto* whole = value.as<std::int64_t>();
  return whole != nullptr ? static_cast<double>(*whole) : *value.as<double>();
}

const Value& at(const Value& value, const std::string& key) {
  return value.as<Value::Map>()->at(key);
}

const Value& at(const Value& value, std::size_t place) {
  return value.as<Value::List>()->at(place);
}

/// A scene of one camera, from its line in the image folder's list.
struct WrittenScene {
  explicit WrittenScene(const std::string& line) : line_(yaml(line)) {}

  [[nodiscard]] std::string name() const { return *at(line_, "file_name").as<std::string>(); }
  [[nodiscard]] double k(std::size_t place) const {
    return numberOf(at(at(at(line_, "camera"), "K"), place));
  }

  [[nodiscard]] std::size_t objectCount() const {
    return at(at(line_, "objects"), "names").as<Value::List>()->size();
  }
  [[nodiscard]] std::string objectName(std::size_t object) const {
    return *at(at(at(line_, "objects"), "names"), object).as<std::string>();
  }

  /// Where the label has a keypoint [px].
  [[nodiscard]] Eigen::Vector2d keypoint(std::size_t object, std::size_t place) const {
    const Value& pixel = at(at(at(at(line_, "objects"), "keypoints"), object), place);
    return {numberOf(at(pixel, std::size_t{0})), numberOf(at(pixel, 1))};
  }

  /// Where the written intrinsics project a point of an object.
  [[nodiscard]] Eigen::Vector2d projected(std::size_t object, const Eigen::Vector3d& p_O) const {
    const Value& matrix = at(at(at(line_, "objects"), "X_CO"), object);
    Eigen::Vector3d p_C;
    for (int row = 0; row < 3; ++row) {
      const auto number = [&](int column) {
        return numberOf(at(matrix, static_cast<std::size_t>(4 * row + column)));
      };
      p_C[row] = number(0) * p_O.x() + number(1) * p_O.y() + number(2) * p_O.z() + number(3);
    }
    return {k(0) * p_C.x() / p_C.z() + k(2), k(4) * p_C.y() / p_C.z() + k(5)};
  }

 private:
  Value line_;
};

/// Two cameras, masks by background subtraction, optical flow; the cameras stand still.
class ZoomingRun : public ::testing::Test {
 protected:
  ZoomingRun() {
    Value::List writers = *run.parameters.at("writers").as<Value::List>();
    writers.erase(std::remove_if(writers.begin(), writers.end(),
                                 [](const Value& writer) {
                                   return *at(writer, "name").as<std::string>() == "w_PvNet";
                                 }),
                  writers.end());
    run.parameters["writers"] = Value(writers);
    run.parameters.erase("w_PvNet");
    // A ball at rest causes no change for which the background would be learnt anew.
    run.parameters["physics"] = yaml("{settle: 3}");
    randomize("{sensor: {field_of_view: {uniform: [0.7, 1.2]}}}");
  }

  void randomize(const std::string& text) { run.parameters["randomize"] = yaml(text); }

  /// Gives the cameras a lens.
  void bend() {
    std::ofstream file(run.input("camera.yaml"));
    file << "image_width: 160\nimage_height: 120\ncamera_matrix: {rows: 3, cols: 3, data: [140, "
            "0, 79.5, 0, 140, 59.5, 0, 0, 1]}\ndistortion_model: plumb_bob\n"
            "distortion_coefficients: {rows: 1, cols: 5, data: [-0.25, 0.08, 0.001, 0, 0]}\n";
  }

  [[nodiscard]] std::vector<WrittenScene> scenesOf(const std::string& camera) const {
    std::ifstream file(run.folder() + "/w_ImageFolder/train/metadata.jsonl");
    std::vector<WrittenScene> scenes;
    for (std::string line; std::getline(file, line);) {
      if (WrittenScene scene(line); scene.name().rfind(camera, 0) == 0) scenes.push_back(scene);
    }
    return scenes;
  }

  /// The first column of a query on the manifest.
  [[nodiscard]] std::vector<double> numbersIn(const std::string& sql) const {
    const base::SqliteDatabase manifest(run.folder() + "/manifest.sqlite",
                                        base::SqliteDatabase::Mode::kReadOnly);
    base::SqliteStatement row(manifest, sql);
    std::vector<double> numbers;
    while (row.step()) numbers.push_back(numberOf(yaml(row.text(0))));
    return numbers;
  }

  [[nodiscard]] std::vector<double> drawn(const std::string& name) const {
    return numbersIn("SELECT value FROM draw WHERE name = '" + name + "' ORDER BY scene");
  }

  AllAtOnceRun run;
};

TEST_F(ZoomingRun, HasTheIntrinsicsThatWereDrawnInLabelsAndManifest) {
  (void)run.run();
  const std::vector<double> angles = drawn("sensor/field_of_view");
  ASSERT_EQ(angles.size(), 16U);
  EXPECT_THAT(angles, Each(AllOf(testing::Ge(0.7), testing::Le(1.2))));
  EXPECT_EQ(std::set<double>(angles.begin(), angles.end()).size(), 16U) << "each draws its own";
  const std::vector<WrittenScene> left = scenesOf("left");
  ASSERT_EQ(left.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR(2.0 * std::atan(80.0 / left[i].k(0)), angles[2 * i], 1e-9);
    EXPECT_DOUBLE_EQ(left[i].k(4), left[i].k(0));
    ASSERT_EQ(left[i].objectCount(), 2U) << i;
    for (std::size_t object = 0; object < 2; ++object) {
      const auto expected = left[i].projected(object, {0.2, 0, 0.4});
      EXPECT_LT((left[i].keypoint(object, 0) - expected).norm(), 1e-6) << i;
    }
  }
}

TEST_F(ZoomingRun, ShowsInThePictureWhatTheLabelsSay) {
  (void)run.run();
  for (const WrittenScene& scene : scenesOf("right")) {
    const cv::Mat image = cv::imread(run.folder() + "/w_ImageFolder/train/" + scene.name());
    for (std::size_t object = 0; object < scene.objectCount(); ++object) {
      const auto middle = scene.projected(object, {-0.2, 0, 0.2});
      const auto above = scene.projected(object, {-0.2, 0, 0.46});
      const auto colourAt = [&](const Eigen::Vector2d& pixel) {
        return image.at<cv::Vec3b>(static_cast<int>(std::lround(pixel.y())),
                                   static_cast<int>(std::lround(pixel.x())));
      };
      const int channel = scene.objectName(object) == "alpha" ? 2 : 0;  // red, blue
      const auto excess = [&](const cv::Vec3b& colour) {
        return colour[channel] - colour[2 - channel];
      };
      EXPECT_GT(excess(colourAt(middle)), 50) << scene.name();
      EXPECT_LT(excess(colourAt(above)), 50) << scene.name();
    }
  }
}

TEST_F(ZoomingRun, HasMasksOfItsOwnBackground) {
  (void)run.run();
  const auto agreement = numbersIn("SELECT mask_agreement FROM scene_object");
  ASSERT_EQ(agreement.size(), 32U);
  EXPECT_THAT(agreement, Each(testing::Gt(0.9)));
}

TEST_F(ZoomingRun, HasAFlowThatLeadsToWhereTheNextSceneHasIt) {
  (void)run.run();
  const std::vector<WrittenScene> scenes = scenesOf("left");
  int compared = 0;
  for (std::size_t i = 0; i + 1 < scenes.size(); ++i) {
    const std::string base = run.folder() + "/w_ImageFolder/train/" +
                             scenes[i].name().substr(0, scenes[i].name().size() - 4);
    const cv::Mat u = cv::imread(base + ".flow_u.tiff", cv::IMREAD_UNCHANGED);
    const cv::Mat v = cv::imread(base + ".flow_v.tiff", cv::IMREAD_UNCHANGED);
    for (std::size_t object = 0; object < 2; ++object) {
      if (scenes[i].objectName(object) != "bravo") continue;  // it stands
      const Eigen::Vector3d front_O(-0.2, 0.0, 0.2);
      const auto from = scenes[i].projected(object, front_O);
      const auto to = scenes[i + 1].projected(object, front_O);
      const cv::Point pixel(static_cast<int>(std::lround(from.x())),
                            static_cast<int>(std::lround(from.y())));
      EXPECT_NEAR(static_cast<double>(u.at<float>(pixel)), (to - from).x(), 0.4) << i;
      EXPECT_NEAR(static_cast<double>(v.at<float>(pixel)), (to - from).y(), 0.4) << i;
      compared += (to - from).norm() > 2.0 ? 1 : 0;
    }
  }
  EXPECT_GT(compared, 3) << "it moves as the picture zooms";
}

TEST_F(ZoomingRun, LeavesOtherDrawsAsTheyAre) {
  randomize("{sensor: {exposure: {uniform: [-1, 1]}, field_of_view: {uniform: [0.7, 1.2]}}}");
  (void)run.run();
  const auto exposures = drawn("sensor/exposure");
  const auto angles = drawn("sensor/field_of_view");
  fs::remove_all(run.folder());
  randomize("{sensor: {exposure: {uniform: [-1, 1]}}}");
  (void)run.run();
  EXPECT_EQ(drawn("sensor/exposure"), exposures);
  fs::remove_all(run.folder());
  randomize("{sensor: {field_of_view: {uniform: [0.7, 1.2]}}, lights: {sun: {intensity: 2}}}");
  (void)run.run();
  EXPECT_EQ(drawn("sensor/field_of_view"), angles);
}

TEST_F(ZoomingRun, GivesTheSameBytesResumedInShardsAndAlone) {
  const Files expected = run.unbroken();
  StoppingReporter stopping(5);
  EXPECT_TRUE(run.run(stopping, run.folder()).stopped);
  (void)run.run();
  run.expectFiles(expected);
  fs::remove_all(run.folder());
  for (const int index : {1, 0}) (void)run.runShard(index, 2, run.folder());
  Reporter silent;
  mergeShards(run.folder(), {}, silent, {test::pluginXml()});
  run.expectFiles(expected);
  fs::remove_all(run.folder());
  run.parameters["only_scenes"] = yaml("[5]");
  EXPECT_EQ(run.run().scenes, 2);
  run.parameters.erase("only_scenes");
  (void)run.run();
  run.expectFiles(expected);
}

class ReusingRun : public ZoomingRun, public ::testing::WithParamInterface<const char*> {};

TEST_P(ReusingRun, GivesTheSameBytesWhereNothingIsKept) {
  const std::string which = GetParam();
  if (which.rfind("Lens", 0) == 0) bend();
  const bool is_exact = which.find("Exact") != std::string::npos;
  run.parameters["masks"] = yaml(is_exact ? "{method: exact}" : "{method: mog2}");
  const Files expected = run.unbroken();
  run.parameters["rendering"] = yaml("{reuse: false}");
  (void)run.run();
  run.expectFiles(expected);
}

INSTANTIATE_TEST_SUITE_P(Cameras, ReusingRun,
                         ::testing::Values("PinholeExact", "PinholeMog2", "LensExact", "LensMog2"),
                         [](const auto& each) { return std::string(each.param); });

TEST_F(ZoomingRun, RefusesAFormatWithOneCalibrationAndAnAngleThatNoLensHas) {
  run.parameters["writers"] = yaml(
      "[{name: w_Bop, type: synthetic_dataset/Bop}, {name: p, type: synthetic_dataset/PvNet}]");
  for (const char* unused : {"w_Coco", "w_ImageFolder", "w_RosBag", "w_UltralyticsYolo"}) {
    run.parameters.erase(unused);
  }
  EXPECT_THAT(run.errors(), ElementsAre(AllOf(HasSubstr("writer 'p'"),
                                              HasSubstr("randomize/sensor/field_of_view"))));
  randomize("{sensor: {field_of_view: 0.9}}");
  EXPECT_THAT(run.errors(), IsEmpty()) << "always the same: one calibration tells it";
  EXPECT_TRUE(fs::exists(run.folder() + "/p/alpha/left/camera.txt"));
  randomize("{sensor: {field_of_view: {normal: [1, 0.1]}}}");
  EXPECT_THAT(run.errors(), Contains(AllOf(HasSubstr("randomize/sensor/field_of_view: found up to"),
                                           HasSubstr("'left'"), HasSubstr("`max`"))));
}

}  // namespace field_of_view_test
}  // namespace synthetic_dataset::run
