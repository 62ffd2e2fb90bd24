/// Recorded pictures with something in them that the twin lacks: a person, as a box. A run with the
/// person in its world gives the truth about what is seen of the objects.

#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <Eigen/Geometry>
#include <opencv2/imgcodecs.hpp>

#include "all_at_once_run.h"
#include "base/sqlite.h"
#include "base/yaml_value.h"
#include "run/live/json_values.h"
#include "run/setup/run_setup.h"
#include "run_fixture.h"
#include "support/bag_builder.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace twin_occlusion_test {

namespace fs = std::filesystem;
using test::BagBuilder;
using test::milliseconds;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

using Files = std::map<std::string, std::string>;

Value yaml(const std::string& text) { return base::parseYaml(text, "test"); }

std::string calibration(int width, int height, double focal) {
  return "image_width: " + std::to_string(width) + "\nimage_height: " + std::to_string(height) +
         "\ncamera_matrix: {rows: 3, cols: 3, data: [" + std::to_string(focal) + ", 0, " +
         std::to_string(0.5 * (width - 1)) + ", 0, " + std::to_string(focal) + ", " +
         std::to_string(0.5 * (height - 1)) +
         ", 0, 0, 1]}\ndistortion_model: plumb_bob\n"
         "distortion_coefficients: {rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}\n";
}

// The depth camera, which is not the pictures' camera.
constexpr int kDepthWidth = 424;
constexpr int kDepthHeight = 320;
constexpr double kDepthFocal = 350.0;

/// The pictures' camera, which looks along x from 3 m before the objects.
Pose pictureCamera() {
  return makePose({-3.0, 0.2, 0.5}, Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5));
}

/// The depth camera, 6 cm to the left and 2 cm higher, turned by 2 degrees.
Pose depthCamera() {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.035, Eigen::Vector3d::UnitY()));
  return pictureCamera() * makePose({-0.06, -0.02, 0.0}, turn);
}

cv::Mat decoded(const std::string& file) {
  return cv::imdecode(std::vector<std::uint8_t>(file.begin(), file.end()), cv::IMREAD_UNCHANGED);
}

/// The name of a scene's file in the dataset.
std::string fileOf(const std::string& kind, std::size_t scene, const std::string& rest) {
  return "bop/train/000000/" + kind + "/00000" + std::to_string(scene) + rest + ".png";
}

/// The numbers of pixels in both masks and in either mask.
struct Overlap {
  int both = 0;
  int either = 0;

  [[nodiscard]] double share() const {
    return either == 0 ? 1.0 : static_cast<double>(both) / either;
  }
};

Overlap overlapOf(const cv::Mat& a, const cv::Mat& b) {
  return {cv::countNonZero(a & b), cv::countNonZero(a | b)};
}

constexpr std::size_t kScenes = 4;

class TwinOcclusion : public test::RunFixture {
 protected:
  TwinOcclusion() {
    std::ifstream file(run.folder() / "tiny.world");
    std::string world((std::istreambuf_iterator<char>(file)), {});
    const std::string person =
        "<model name='person'><static>true</static><pose>-1.2 0.1 0.6 0 0 0.3</pose><link "
        "name='body'><visual name='v'><geometry><box><size>0.15 0.15 1.2</size></box></geometry>"
        "</visual></link></model>";
    world.insert(world.find("</world>"), person);
    with_person = run.folder().write("person.world", world).string();
    run.folder().write("big.yaml", calibration(640, 480, 560.0));
    run.folder().write("depth.yaml", calibration(kDepthWidth, kDepthHeight, kDepthFocal));
    parameters["writers"] = yaml(
        "[{name: bop, type: synthetic_dataset/Bop}, "
        "{name: pose, type: synthetic_dataset/UltralyticsYolo}]");
    parameters["pose"] = yaml("{task: pose}");
    parameters["masks"] = yaml("{method: exact}");
    parameters.erase("background_subtractor");
    setCamera("depth.yaml", depthCamera());
    depths = made(with_person);
    setCamera("big.yaml", pictureCamera());
    truth = made(with_person);
    true_states = keypointStates();
    empty = made((run.folder() / "tiny.world").string());
    parameters.erase("simulated_rate");
    Value::Map camera = *parameters.at("camera").as<Value::Map>();
    camera["image_topic"] = Value("/eye/image_raw");
    parameters["camera"] = Value(camera);
  }

  void setCamera(const std::string& file, const Pose& X_GC) {
    parameters["camera"] = Value(Value::Map{{"info_file", Value((run.folder() / file).string())},
                                            {"pose", poseValue(X_GC)}});
  }

  Files made(const std::string& world) {
    parameters["world"] = Value(world);
    return filesAnew();
  }

  /// The states of all keypoints in all scenes.
  [[nodiscard]] std::vector<std::string> keypointStates() const {
    return rows("SELECT state FROM scene_keypoint ORDER BY scene, object, sequence");
  }

  /// The first column of a query on the manifest.
  [[nodiscard]] std::vector<std::string> rows(const std::string& query) const {
    const base::SqliteDatabase manifest(folder + "/manifest.sqlite",
                                        base::SqliteDatabase::Mode::kReadOnly);
    base::SqliteStatement found(manifest, query);
    std::vector<std::string> all;
    while (found.step()) all.push_back(found.text(0));
    return all;
  }

  /// Records the pictures of all scenes, with the person in them, and what `measure` adds.
  template <class Measure>
  void record(const Measure& measure) {
    BagBuilder bag(run.folder() / "pictures.bag");
    for (std::size_t i = 0; i < kScenes; ++i) {
      const Stamp stamp = milliseconds(1000 + 250 * static_cast<int>(i));
      bag.from("eye_optical");
      bag.picture("/eye/image_raw", stamp, decoded(truth.at(fileOf("rgb", i, ""))), "bgr8");
      measure(bag, stamp, i);
    }
    parameters["bag_file"] =
        Value(Value::List{Value((run.folder() / "tiny.bag").string()), Value(bag.close())});
  }

  /// Records the pose and the calibration of the depth camera.
  static void describeDepthCamera(BagBuilder& bag, Stamp stamp) {
    bag.fix("map", "depth_optical", stamp, depthCamera());
    bag.from("depth_optical");
    bag.resizeCamera(kDepthWidth, kDepthHeight);
    bag.calibrate("/depth/camera_info", "depth_optical", stamp, kDepthFocal);
  }

  /// Intersection over union with the truth: of the worst mask, and of all masks of all scenes.
  struct Agreement {
    double worst = 1.0;
    double all = 1.0;
  };
  [[nodiscard]] Agreement masksOf(const Files& labels) {
    Agreement agreement;
    Overlap all;
    for (const auto& [name, file] : truth) {
      if (name.find("/mask_visib/") == std::string::npos) continue;
      if (labels.count(name) == 0) return {0.0, 0.0};
      const Overlap overlap = overlapOf(decoded(file), decoded(labels.at(name)));
      agreement.worst = std::min(agreement.worst, overlap.share());
      all.both += overlap.both;
      all.either += overlap.either;
    }
    agreement.all = all.share();
    RecordProperty("worst_mask", std::to_string(agreement.worst));
    RecordProperty("all_masks", std::to_string(agreement.all));
    return agreement;
  }

  std::string with_person;  ///< the world's file
  Files depths;             ///< of the depth camera
  Files truth;              ///< with the person, as in the pictures
  Files empty;              ///< without the person, as in the twin
  std::vector<std::string> true_states;
};

TEST_F(TwinOcclusion, IsNotKnownWithoutDepth) {
  record([](BagBuilder& /*bag*/, Stamp /*stamp*/, std::size_t /*scene*/) {});
  const Files labels = filesAnew();
  EXPECT_LT(masksOf(labels).worst, 0.6) << "the person stands before an object";
  EXPECT_THAT(rows("SELECT unmeasured FROM scene_cover"), testing::Each("1.0"));
  EXPECT_EQ(rows("SELECT covered FROM object_cover").size(), 2 * kScenes);
  const RunSetup setup = setUpRun(Value(parameters), {test::pluginXml()});
  EXPECT_THAT(setup.diagnostics.messages(base::Severity::kNote),
              testing::Contains(HasSubstr("neither depth_topic nor cloud_topic is set")));
}

TEST_F(TwinOcclusion, IsCutByTheDepthOfTheSameCamera) {
  record([&](BagBuilder& bag, Stamp stamp, std::size_t scene) {
    bag.picture("/eye/depth", stamp, decoded(truth.at(fileOf("depth", scene, ""))), "16UC1");
  });
  parameters["twin"] = yaml("{depth_topic: /eye/depth}");
  const Files labels = filesAnew();
  EXPECT_GT(masksOf(labels).worst, 0.99);
  EXPECT_EQ(keypointStates(), true_states);
  EXPECT_THAT(true_states, testing::Contains("hidden by another"));
  EXPECT_THAT(rows("SELECT unmeasured FROM scene_cover"), testing::Each("0.0"));
  EXPECT_EQ(rows("SELECT 1 FROM object_cover WHERE covered > 0.3").size(), 2U);
  for (std::size_t i = 0; i < kScenes; ++i) {
    const std::string silhouette = fileOf("mask", i, "_000000");
    EXPECT_EQ(labels.at(silhouette), empty.at(silhouette))
        << "what is hidden keeps its whole label";
  }
}

TEST_F(TwinOcclusion, IsCutByTheDepthOfAnotherCamera) {
  record([&](BagBuilder& bag, Stamp stamp, std::size_t scene) {
    describeDepthCamera(bag, stamp);
    cv::Mat metres;
    decoded(depths.at(fileOf("depth", scene, ""))).convertTo(metres, CV_32F, 1e-3);
    bag.picture("/depth/image", stamp + milliseconds(20), metres, "32FC1");
  });
  parameters["twin"] = yaml("{depth_topic: /depth/image}");
  EXPECT_GT(masksOf(filesAnew()).worst, 0.94) << "of pixels that are 1.6 of the picture's";
  EXPECT_EQ(keypointStates(), true_states);
}

TEST_F(TwinOcclusion, IsCutByACloudWhereItHasPoints) {
  record([&](BagBuilder& bag, Stamp stamp, std::size_t scene) {
    describeDepthCamera(bag, stamp);
    const cv::Mat depth = decoded(depths.at(fileOf("depth", scene, "")));
    std::vector<Eigen::Vector3d> points;
    for (int y = 0; y < depth.rows; y += 6) {  // rings of a scanner
      for (int x = 0; x < depth.cols; x += 2) {
        const double z = 1e-3 * depth.at<std::uint16_t>(y, x);
        const bool is_hole = x > 300;
        if (z <= 0.0 || is_hole) continue;
        points.emplace_back(z * (x - 0.5 * (kDepthWidth - 1)) / kDepthFocal,
                            z * (y - 0.5 * (kDepthHeight - 1)) / kDepthFocal, z);
      }
    }
    bag.cloud("/points", stamp, points);
  });
  parameters["twin"] = yaml("{cloud_topic: /points}");
  const Agreement masks = masksOf(filesAnew());
  EXPECT_GT(masks.all, 0.96);
  EXPECT_GT(masks.worst, 0.8) << "of what is 20 pixels wide, by points that are 3 and 10 apart";
  EXPECT_EQ(keypointStates(), true_states);
}

TEST_F(TwinOcclusion, TellsTheShareThatNothingMeasures) {
  record([&](BagBuilder& bag, Stamp stamp, std::size_t scene) {
    cv::Mat depth = decoded(truth.at(fileOf("depth", scene, "")));
    depth.colRange(0, depth.cols / 2).setTo(0);
    bag.picture("/eye/depth", stamp, depth, "16UC1");
  });
  parameters["twin"] = yaml("{depth_topic: /eye/depth}");
  (void)filesAnew();
  const base::SqliteDatabase manifest(folder + "/manifest.sqlite",
                                      base::SqliteDatabase::Mode::kReadOnly);
  base::SqliteStatement found(manifest, "SELECT scene, object, unmeasured FROM object_cover");
  while (found.step()) {
    const auto scene = static_cast<std::size_t>(found.integer(0));
    const std::string object = "_00000" + std::to_string(found.integer(1));
    const cv::Mat mask = decoded(empty.at(fileOf("mask_visib", scene, object)));
    const double left = cv::countNonZero(mask.colRange(0, mask.cols / 2));
    EXPECT_NEAR(found.real(2), left / cv::countNonZero(mask), 1e-9);
  }
}

TEST_F(TwinOcclusion, CountsScenesWithoutAMeasurementNearby) {
  record([&](BagBuilder& bag, Stamp stamp, std::size_t scene) {
    if (scene == 0) return;
    bag.picture("/eye/depth", stamp, decoded(truth.at(fileOf("depth", scene, ""))), "16UC1");
  });
  parameters["twin"] = yaml("{depth_topic: /eye/depth, depth_time: 0.2}");
  fs::remove_all(folder);
  EXPECT_THAT(generate().warnings,
              testing::Contains(testing::Pair(
                  HasSubstr("scene without a depth image within 200 ms (twin/depth_time)"), 1)));
}

TEST_F(TwinOcclusion, NamesWhatIsWrongWithWhatWasMeasured) {
  record([&](BagBuilder& bag, Stamp stamp, std::size_t scene) {
    const cv::Mat depth = decoded(truth.at(fileOf("depth", scene, "")));
    bag.picture("/eye/depth", stamp, depth, "16UC1");
    bag.picture("/eye/small", stamp, cv::Mat(depth(cv::Rect(0, 0, 64, 48)).clone()), "16UC1");
    bag.picture("/eye/late", stamp + milliseconds(100), depth, "16UC1");
    bag.from("elsewhere");
    bag.picture("/other/depth", stamp, depth, "16UC1");
    bag.calibrate("/third/camera_info", "elsewhere", stamp, 100.0);
    bag.cloud("/points", stamp, {{1, 0, 0}});
  });
  const auto errorsOf = [&](const std::string& twin) {
    parameters["twin"] = yaml(twin);
    return errors();
  };
  EXPECT_THAT(errorsOf("{depth_topic: /eye/dept}"),
              ElementsAre(AllOf(HasSubstr("twin/depth_topic: found '/eye/dept'"),
                                HasSubstr("did you mean '/eye/depth'"))));
  EXPECT_THAT(errorsOf("{cloud_topic: /eye/depth}"),
              ElementsAre(AllOf(HasSubstr("twin/cloud_topic: found '/eye/depth', whose messages "
                                          "are sensor_msgs/Image"),
                                HasSubstr("sensor_msgs/PointCloud2"))));
  EXPECT_THAT(errorsOf("{depth_topic: /eye/image_raw}"),
              ElementsAre(HasSubstr("has the encoding 'bgr8'; depth should be 32FC1")));
  EXPECT_THAT(errorsOf("{depth_topic: /eye/small}"),
              ElementsAre(AllOf(HasSubstr("64 x 48 pixels; its calibration is of 640 x 480"),
                                HasSubstr("twin/depth_info_topic should name"))));
  EXPECT_THAT(errorsOf("{depth_topic: /eye/late}"),
              ElementsAre(HasSubstr("no depth image is within 50 ms (twin/depth_time) of a "
                                    "picture; the nearest are 100 ms away")));
  EXPECT_THAT(errorsOf("{depth_topic: /other/depth}"),
              ElementsAre(AllOf(HasSubstr("twin/depth_info_topic: missing"),
                                HasSubstr("have the frame 'elsewhere'"),
                                HasSubstr("it has /third/camera_info"))));
  EXPECT_THAT(errorsOf("{cloud_topic: /points}"),
              ElementsAre(HasSubstr("is in the frame 'elsewhere'; the recording has no frame")));
  EXPECT_THAT(errorsOf("{depth_margin: 0.2}"),
              ElementsAre(HasSubstr("twin/depth_margin: found without depth_topic")));
}

}  // namespace twin_occlusion_test
}  // namespace synthetic_dataset::run
