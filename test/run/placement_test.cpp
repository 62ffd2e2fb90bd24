/// Runs whose objects and cameras are placed at random.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include <gmock/gmock.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "all_at_once_run.h"
#include "base/sqlite.h"
#include "run/generator.h"
#include "run/merger.h"
#include "run_fixture.h"
#include "support/bag_builder.h"
#include "support/writers/plugin_environment.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::run {
namespace placement_test {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using test::AllAtOnceRun;
using test::milliseconds;
using test::poseAt;
using test::StoppingReporter;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;

Value listOf(const std::vector<double>& numbers) {
  return Value(Value::List(numbers.begin(), numbers.end()));
}

/// A map_server map of a free square of 3 m about the origin, below `folder`. Returns its file.
std::string writeMap(const fs::path& folder) {
  std::ofstream(folder / "map.pgm", std::ios::binary) << "P5\n24 24\n255\n"
                                                      << std::string(24 * 24, '\xFE');
  std::ofstream(folder / "map.yaml")
      << "image: map.pgm\nresolution: 0.125\norigin: [-1.5, -1.5, 0]\nnegate: 0\n"
         "occupied_thresh: 0.65\nfree_thresh: 0.196\n";
  return (folder / "map.yaml").string();
}

Value::Map volumeOf(const std::vector<double>& low, const std::vector<double>& high,
                    const std::string& mode = "volume") {
  return {{"mode", Value(mode)},
          {"volume", Value(Value::Map{{"min", listOf(low)}, {"max", listOf(high)}})}};
}

/// The manifest's data of an object in a scene.
struct ManifestObject {
  Pose X_GO;
  std::int64_t visible_pixels;
  double visibility;
  std::array<double, 4> visible_box;  ///< left, top, right, bottom [px]
};

struct ManifestScene {
  Stamp stamp;
  Pose X_GC;
  std::vector<ManifestObject> objects;
};

Pose poseIn(const base::SqliteStatement& row, int first) {
  const auto number = [&](int i) { return row.real(first + i); };
  return makePose({number(0), number(1), number(2)},
                  Eigen::Quaterniond(number(6), number(3), number(4), number(5)));
}

std::vector<ManifestScene> scenesIn(const fs::path& folder) {
  const base::SqliteDatabase manifest((folder / "manifest.sqlite").string(),
                                      base::SqliteDatabase::Mode::kReadOnly);
  std::vector<ManifestScene> scenes;
  base::SqliteStatement scene(
      manifest, "SELECT stamp_ns, x, y, z, qx, qy, qz, qw FROM scene ORDER BY \"index\"");
  while (scene.step()) scenes.push_back({Stamp(scene.integer(0)), poseIn(scene, 1), {}});
  base::SqliteStatement object(manifest,
                               "SELECT scene, x, y, z, qx, qy, qz, qw, visible_pixels, visibility, "
                               "visible_left, visible_top, visible_right, visible_bottom "
                               "FROM scene_object ORDER BY scene, object");
  while (object.step()) {
    scenes[static_cast<std::size_t>(object.integer(0))].objects.push_back(
        {poseIn(object, 1),
         object.integer(8),
         object.real(9),
         {object.real(10), object.real(11), object.real(12), object.real(13)}});
  }
  return scenes;
}

class PlacementTest : public test::RunFixture {
 protected:
  PlacementTest() {
    parameters["if_exists"] = Value("overwrite");
    parameters.erase("bag_file");
    parameters["motion"] = Value("placement");
    parameters["scenes"] = Value(6);
    placement({{"map", Value(writeMap(run.folder().path()))}});
  }

  void placement(const Value::Map& settings) { parameters["placement"] = Value(settings); }

  Value::Map& group(const std::string& name) { return *parameters.at(name).as<Value::Map>(); }

  /// Replaces the camera's `pose` with these settings.
  void putCamera(const Value::Map& settings) {
    group("camera").erase("pose");
    for (const auto& [name, value] : settings) group("camera")[name] = value;
  }

  [[nodiscard]] std::vector<ManifestScene> generatedScenes() const {
    (void)generate();
    return scenesIn(folder);
  }

  /// Adds a format for which visible pixels are counted.
  void countVisiblePixels() {
    parameters.erase("bounding_shape");
    parameters.erase("background_subtractor");
    Value::List writers;
    for (const auto& [name, type] : {std::pair("yolo", "Yolo"), {"coco", "Coco"}}) {
      writers.emplace_back(Value::Map{{"name", Value(name)},
                                      {"type", Value("synthetic_dataset/" + std::string(type))}});
    }
    parameters["writers"] = Value(writers);
  }

  /// The same map in a bag.
  void recordMap(const std::string& frame) {
    test::BagBuilder::Map map;
    map.frame = frame;
    map.recorded = milliseconds(1000);
    map.width = map.height = 24;
    map.resolution = 0.125F;
    map.X_FM = poseAt(-1.5, -1.5, 0.0);
    map.cells.assign(24 * 24, 0);
    parameters["bag_file"] = Value(test::BagBuilder(run.folder() / "map.bag").map(map).close());
    placement({{"map_topic", Value("/map")}});
  }

  void useBag() {
    for (const char* name : {"motion", "scenes", "placement"}) parameters.erase(name);
    parameters["bag_file"] = Value((run.folder() / "tiny.bag").string());
  }
};

/// The corners of alpha's and bravo's box, in its frame.
std::vector<Vector3d> cornersOfBox() {
  std::vector<Vector3d> corners;
  for (const double x : {-0.2, 0.2}) {
    for (const double y : {-0.2, 0.2}) {
      for (const double z : {0.0, 0.4}) corners.emplace_back(x, y, z);
    }
  }
  return corners;
}

/// A box as the run's camera sees it: left, top, right, bottom [px].
std::array<double, 4> projected(const Pose& X_CO) {
  std::array<double, 4> box{1e9, 1e9, -1e9, -1e9};
  for (const Vector3d& corner : cornersOfBox()) {
    const Vector3d p_C = X_CO * corner;
    const double u = 79.5 + 140.0 * p_C.x() / p_C.z();
    const double v = 59.5 + 140.0 * p_C.y() / p_C.z();
    box = {std::min(box[0], u), std::min(box[1], v), std::max(box[2], u), std::max(box[3], v)};
  }
  return box;
}

// --- Objects ---

TEST_F(PlacementTest, WritersKnowAnObjectsFrameWhileTheNextSceneIsPlaced) {
  parameters["scenes"] = Value(20);
  group("bounding_shape")["output_frame"] = Value("alpha/base_link");
  (void)generate();
  std::set<std::string> lines;  // of alpha in its own frame: always the same
  for (const auto& entry : fs::directory_iterator(run.folder() / "out/bounding_shape")) {
    if (entry.path().extension() != ".txt") continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      if (line.rfind("bravo", 0) != 0) lines.insert(line);
    }
  }
  EXPECT_THAT(lines, ::testing::SizeIs(1));
}

TEST_F(PlacementTest, MakesAsManyScenesAsAreAskedFor) {
  const std::vector<ManifestScene> scenes = generatedScenes();
  ASSERT_EQ(scenes.size(), 6U);
  for (const char* number : {"00000000", "00000005"}) {
    EXPECT_TRUE(fs::exists(run.folder() / "out/yolo" / (std::string(number) + ".png")));
    EXPECT_TRUE(
        fs::exists(run.folder() / "out/stvnet/alpha/mask" / (std::string(number) + ".png")));
  }
  EXPECT_FALSE(fs::exists(run.folder() / "out/yolo/00000006.png"));
  // Four scenes a second, from the first one on.
  EXPECT_EQ(scenes[0].stamp, milliseconds(250));
  EXPECT_EQ(scenes[5].stamp, milliseconds(1500));
}

TEST_F(PlacementTest, LabelsWhatTheCameraSees) {
  parameters["scenes"] = Value(12);
  countVisiblePixels();
  int compared = 0;
  for (const ManifestScene& scene : generatedScenes()) {
    for (const ManifestObject& object : scene.objects) {
      const std::array<double, 4> box = projected(scene.X_GC.inverse() * object.X_GO);
      const bool in_image = box[0] > 0 && box[1] > 0 && box[2] < 159 && box[3] < 119;
      if (!in_image || object.visibility < 0.999) continue;
      ++compared;
      for (std::size_t side = 0; side < 4; ++side) {
        EXPECT_NEAR(object.visible_box[side], box[side], 1.01) << side;
      }
      EXPECT_GT(object.visible_pixels, 100);
    }
  }
  EXPECT_GT(compared, 8);
}

TEST_F(PlacementTest, ShowsObjectsWhereTheLabelsSay) {
  countVisiblePixels();
  int compared = 0;
  const std::vector<ManifestScene> scenes = generatedScenes();
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const cv::Mat image =
        cv::imread((run.folder() / "out/yolo" / ("0000000" + std::to_string(i) + ".png")).string());
    for (std::size_t k = 0; k < 2; ++k) {
      const ManifestObject& object = scenes[i].objects[k];
      if (object.visibility < 0.999) continue;
      const Vector3d p_C = scenes[i].X_GC.inverse() * (object.X_GO * Vector3d(0, 0, 0.2));
      const cv::Point pixel(static_cast<int>(std::lround(79.5 + 140.0 * p_C.x() / p_C.z())),
                            static_cast<int>(std::lround(59.5 + 140.0 * p_C.y() / p_C.z())));
      if (!cv::Rect(0, 0, 160, 120).contains(pixel)) continue;
      ++compared;
      const cv::Vec3b colour = image.at<cv::Vec3b>(pixel);
      const int red_beyond_blue = colour[2] - colour[0];  // alpha is red, bravo blue
      EXPECT_GT(k == 0 ? red_beyond_blue : -red_beyond_blue, 30) << i;
    }
  }
  EXPECT_GT(compared, 4);
}

TEST_F(PlacementTest, PutsObjectsOnTheFreePlacesOfTheMap) {
  parameters["scenes"] = Value(20);
  (*parameters.at("alpha").as<Value::Map>())["safety_radius"] = Value(0.5);
  for (const ManifestScene& scene : generatedScenes()) {
    const Vector3d alpha = scene.objects[0].X_GO.translation();
    const Vector3d bravo = scene.objects[1].X_GO.translation();
    EXPECT_LE(alpha.head<2>().cwiseAbs().maxCoeff(), 1.5 - 0.5);
    EXPECT_LE(bravo.head<2>().cwiseAbs().maxCoeff(), 1.5 - std::hypot(0.2, 0.2) + 1e-9);
    EXPECT_GE((alpha - bravo).norm(), 0.5 + std::hypot(0.2, 0.2) - 1e-9);
    EXPECT_NEAR(alpha.z(), 0.0, 1e-6) << "its frame is at its bottom";
    EXPECT_NEAR(scene.objects[0].X_GO.linear()(2, 2), 1.0, 1e-9);
  }
}

TEST_F(PlacementTest, StandsObjectsOnTheGroundWithoutAMap) {
  parameters["placement"] = Value(Value::Map{
      {"mode", Value("ground")},
      {"area", Value(Value::Map{{"min", listOf({-1.0, -1.0})}, {"max", listOf({1.0, 1.0})}})}});
  (void)generate();
  for (const ManifestScene& scene : scenesIn(folder)) {
    for (const ManifestObject& object : scene.objects) {
      const Vector3d p_G = object.X_GO.translation();
      EXPECT_NEAR(p_G.z(), 0.0, 1e-4) << "the floor's height";
      EXPECT_LE(p_G.head<2>().cwiseAbs().maxCoeff(), 1.0);
    }
  }
}

TEST_F(PlacementTest, PutsObjectsAnywhereInAVolume) {
  placement(volumeOf({-1, -1, 0.5}, {1, 1, 2}));
  std::set<double> heights;
  for (const ManifestScene& scene : generatedScenes()) {
    for (const ManifestObject& object : scene.objects) {
      const Eigen::Array3d p_G = object.X_GO.translation().array();
      EXPECT_TRUE((p_G >= Eigen::Array3d(-1, -1, 0.5)).all());
      EXPECT_TRUE((p_G <= Eigen::Array3d(1, 1, 2)).all());
      EXPECT_LT(object.X_GO.linear()(2, 2), 1.0 - 1e-6) << "turned anyhow";
      heights.insert(p_G.z());
    }
  }
  EXPECT_EQ(heights.size(), 12U);
}

TEST_F(PlacementTest, LaysDownWhatIsDropped) {
  placement(volumeOf({-0.5, -0.5, 0.6}, {0.5, 0.5, 1.5}, "drop"));
  for (const ManifestScene& scene : generatedScenes()) {
    double lowest = 1e9;
    for (const ManifestObject& object : scene.objects) {
      for (const Vector3d& corner : cornersOfBox()) {
        lowest = std::min(lowest, (object.X_GO * corner).z());
      }
    }
    EXPECT_NEAR(lowest, 0.0, 0.01);
  }
}

TEST_F(PlacementTest, TakesARecordedMap) {
  const std::vector<ManifestScene> of_file = generatedScenes();
  recordMap("map");
  parameters["global_frame"] = Value("/map");
  const std::vector<ManifestScene> of_bag = generatedScenes();
  ASSERT_EQ(of_bag.size(), of_file.size());
  for (std::size_t i = 0; i < of_bag.size(); ++i) {
    EXPECT_TRUE(of_bag[i].objects[1].X_GO.isApprox(of_file[i].objects[1].X_GO, 1e-12)) << i;
  }
}

TEST_F(PlacementTest, PutsObjectsElsewhereWithAnotherSeed) {
  const Pose X_GO = generatedScenes()[2].objects[0].X_GO;
  EXPECT_TRUE(generatedScenes()[2].objects[0].X_GO.matrix() == X_GO.matrix());
  parameters["seed"] = Value(8);
  EXPECT_FALSE(generatedScenes()[2].objects[0].X_GO.isApprox(X_GO, 1e-3));
}

TEST_F(PlacementTest, NothingMovesWhileTheShutterIsOpen) {
  const auto picture = [&] {
    return cv::imread((run.folder() / "out/yolo/00000003.png").string());
  };
  (void)generate();
  const cv::Mat sharp = picture();
  group("camera")["effects"] =
      Value(Value::Map{{"exposure_time", Value(0.1)}, {"motion_samples", Value(3)}});
  (void)generate();
  ASSERT_FALSE(sharp.empty());
  EXPECT_LE(cv::norm(picture(), sharp, cv::NORM_INF), 1.0) << "up to rounding";
}

TEST_F(PlacementTest, TellsTheSafetyRadiusThatFollowsFromTheModel) {
  class Listener : public Reporter {
   public:
    void info(const std::string& message) override { said.push_back(message); }
    std::vector<std::string> said;
  } listener;
  Generator generator(Value(parameters), listener, {test::pluginXml()});
  EXPECT_THAT(listener.said, Contains("alpha/safety_radius: 0.283 m, how far the model reaches"));
}

// --- Cameras ---

TEST_F(PlacementTest, ACameraRidesOnAnObject) {
  const Pose X_OC = makePose({0.3, 0, 0.3}, Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5));
  putCamera(
      {{"mounted_on", Value("alpha")}, {"pose", listOf({0.3, 0, 0.3, -0.5, 0.5, -0.5, 0.5})}});
  for (const ManifestScene& scene : generatedScenes()) {
    EXPECT_TRUE(scene.X_GC.isApprox(scene.objects[0].X_GO * X_OC, 1e-9));
  }
}

TEST_F(PlacementTest, ACameraRidesOnARecordedObject) {
  useBag();
  putCamera(
      {{"mounted_on", Value("alpha")}, {"pose", listOf({0.3, 0, 0.3, -0.5, 0.5, -0.5, 0.5})}});
  const std::vector<ManifestScene> scenes = generatedScenes();
  ASSERT_EQ(scenes.size(), 4U);
  for (const ManifestScene& scene : scenes) {
    // alpha goes 1 m/s along y, from -0.5 m at 1 s.
    const Vector3d expected(0.3, toSeconds(scene.stamp) - 1.5, 0.3);
    EXPECT_TRUE(scene.X_GC.translation().isApprox(expected, 1e-9));
    EXPECT_TRUE(scene.X_GC.linear().col(2).isApprox(Vector3d::UnitX(), 1e-9)) << "it looks ahead";
  }
}

TEST_F(PlacementTest, ASampledCameraLooksAtTheObject) {
  putCamera({{"sample", Value(Value::Map{
                            {"look_at", Value("bravo")},
                            {"distance", Value(Value::Map{{"uniform", listOf({1.5, 2.5})}})}})}});
  std::set<double> places;
  for (const ManifestScene& scene : generatedScenes()) {
    const ManifestObject& bravo = scene.objects[1];
    const Vector3d middle_C = scene.X_GC.inverse() * (bravo.X_GO * Vector3d(0, 0, 0.2));
    EXPECT_LT(middle_C.head<2>().norm(), 1e-6);
    EXPECT_GE(middle_C.z(), 1.5);
    EXPECT_LE(middle_C.z(), 2.5);
    places.insert(scene.X_GC.translation().x());
  }
  EXPECT_EQ(places.size(), 6U);
}

TEST_F(PlacementTest, ASampledCameraFollowsARecording) {
  useBag();
  putCamera({{"sample", Value(Value::Map{{"look_at", Value("alpha")}})}});
  const std::vector<ManifestScene> scenes = generatedScenes();
  ASSERT_EQ(scenes.size(), 4U);
  std::set<double> places;
  for (const ManifestScene& scene : scenes) {
    const Vector3d middle_G(0, toSeconds(scene.stamp) - 1.5, 0.2);
    EXPECT_LT((scene.X_GC.inverse() * middle_G).head<2>().norm(), 1e-6);
    EXPECT_GT(scene.X_GC.translation().z(), 0.2);
    places.insert(scene.X_GC.translation().x());
  }
  EXPECT_EQ(places.size(), 4U);
}

TEST_F(PlacementTest, WritersKnowTheFrameOfASampledCamera) {
  putCamera({{"sample", Value(Value::Map{{"look_at", Value("bravo")}})}});
  group("bounding_shape")["output_frame"] = Value("camera/optical_link");
  const std::vector<ManifestScene> scenes = generatedScenes();
  const std::string text = test::readFile(run.folder() / "out/bounding_shape/00000002.txt");
  std::istringstream numbers(text.substr(text.find("bravo ") + 6));
  Vector3d written;
  numbers >> written.x() >> written.y() >> written.z();
  const Vector3d expected =
      scenes[2].X_GC.inverse() * (scenes[2].objects[1].X_GO * Vector3d(-0.2, -0.2, 0.0));
  EXPECT_LT((written - expected).norm(), 1e-4);
}

// --- Stopped, resumed, in shards ---

/// Two cameras, many formats; objects fall onto the ball, one camera is put at random.
class PlacedAllAtOnce : public ::testing::Test {
 protected:
  PlacedAllAtOnce() {
    run.parameters.erase("bag_file");
    run.parameters["motion"] = Value("placement");
    run.parameters["scenes"] = Value(7);
    run.parameters["placement"] = Value(volumeOf({-0.5, -1.0, 0.6}, {0.5, 0.5, 1.5}, "drop"));
    sample("left");
  }

  void sample(const std::string& camera) {
    Value::Map& cameras = *run.parameters.at("cameras").as<Value::Map>();
    Value::Map& settings = *cameras.at(camera).as<Value::Map>();
    settings.erase("pose");
    settings["sample"] = Value(Value::Map{{"look_at", Value("any")}});
  }

  void expectShardsMakeTheSame(int count) const {
    const auto expected = run.unbroken();
    for (int i = 0; i < count; ++i) (void)run.runShard((i + 1) % count, count, run.folder());
    Reporter silent;
    mergeShards(run.folder(), {}, silent, {test::pluginXml()});
    const auto made = AllAtOnceRun::files(run.folder());
    EXPECT_EQ(made.size(), expected.size());
    for (const auto& [name, content] : expected) {
      const auto found = made.find(name);
      EXPECT_TRUE(found != made.end() && found->second == content) << name;
    }
  }

  AllAtOnceRun run;
};

TEST_F(PlacedAllAtOnce, GivesTheBytesOfAnUnbrokenRunWhenResumed) {
  const auto expected = run.unbroken();
  ASSERT_GT(expected.size(), 100U);
  StoppingReporter stopping(5);
  EXPECT_TRUE(run.run(stopping, run.folder()).stopped);
  EXPECT_LT(run.run().scenes, 14);
  EXPECT_TRUE(AllAtOnceRun::files(run.folder()) == expected);
}

TEST_F(PlacedAllAtOnce, GivesTheBytesOfASingleRunInShards) { expectShardsMakeTheSame(2); }

TEST_F(PlacedAllAtOnce, GivesTheSameBytesWhateverIsKeptFromPictureToPicture) {
  const auto filesWith = [&](bool reuse) {
    run.parameters["rendering"] = Value(Value::Map{{"reuse", Value(reuse)}});
    auto files = run.unbroken();
    files.erase("manifest.sqlite");  // which contains the setting
    return files;
  };
  EXPECT_TRUE(filesWith(true) == filesWith(false));
}

TEST_F(PlacedAllAtOnce, GivesTheSameBytesInShardsWithACameraPutIntoARecording) {
  run.parameters = AllAtOnceRun().parameters;  // in the same folder
  sample("left");
  expectShardsMakeTheSame(3);
}

// --- Errors ---

TEST_F(PlacementTest, NamesAMapThatIsMissing) {
  placement({{"map", Value("/nowhere/map.yaml")}});
  EXPECT_THAT(errors(),
              Contains(AllOf(HasSubstr("placement/map"), HasSubstr("/nowhere/map.yaml"))));
}

TEST_F(PlacementTest, NamesATopicThatIsNotRecorded) {
  parameters["bag_file"] = Value((run.folder() / "tiny.bag").string());
  placement({{"map_topic", Value("/map")}});
  EXPECT_THAT(errors(), Contains(AllOf(HasSubstr("placement/map_topic: "), HasSubstr("'/map'"))));
}

TEST_F(PlacementTest, NamesTheFrameOfAMapThatIsElsewhere) {
  recordMap("odom");
  EXPECT_THAT(errors(), Contains(AllOf(HasSubstr("placement/map_topic: "), HasSubstr("'odom'"),
                                       HasSubstr("global_frame, 'map'"))));
}

TEST_F(PlacementTest, NamesTheBagThatARecordedMapNeeds) {
  placement({{"map_topic", Value("/map")}});
  EXPECT_THAT(errors(), Contains(AllOf(HasSubstr("placement/map_topic: "), HasSubstr("bag_file"))));
}

TEST_F(PlacementTest, NamesASafetyRadiusThatTheMapHasNoPlaceFor) {
  group("alpha")["safety_radius"] = Value(2.0);
  EXPECT_THAT(errors(), Contains(HasSubstr("alpha/safety_radius is 2.000 m")));
}

TEST_F(PlacementTest, NamesAnObjectThatCannotFall) {
  std::string world = test::readFile(run.folder() / "tiny.world");
  const std::size_t begin = world.find("<collision name='c'>", world.find("model name='bravo'"));
  const std::string end = "</collision>";
  world.erase(begin, world.find(end, begin) + end.size() - begin);
  run.folder().write("tiny.world", world);
  placement(volumeOf({-1, -1, 1}, {1, 1, 2}, "drop"));
  EXPECT_THAT(errors(), Contains(HasSubstr("object 'bravo': it cannot be dropped")));
}

TEST_F(PlacementTest, NamesACarrierThatIsNoObject) {
  putCamera({{"mounted_on", Value("alpa")}});
  EXPECT_THAT(errors(), Contains(AllOf(HasSubstr("camera/mounted_on: found 'alpa'"),
                                       HasSubstr("did you mean 'alpha'?"))));
}

TEST_F(PlacementTest, NamesATargetThatIsNoObject) {
  putCamera({{"sample", Value(Value::Map{{"look_at", Value("brovo")}})}});
  EXPECT_THAT(errors(), Contains(AllOf(HasSubstr("camera/sample/look_at: found 'brovo'"),
                                       HasSubstr("did you mean 'bravo'?"))));
}

TEST_F(PlacementTest, NamesACameraWhoseFrameIsAnothers) {
  putCamera({{"sample", Value(Value::Map{{"look_at", Value("alpha")}})},
             {"frame_id", Value("alpha/base_link")}});
  parameters.erase("camera_frame_id");
  EXPECT_THAT(errors(),
              Contains(HasSubstr("camera/frame_id: found 'alpha/base_link', which is also "
                                 "the frame of alpha")));
}

TEST_F(PlacementTest, NamesObjectsWithOneFrame) {
  group("bravo").erase("frame_id");
  group("bravo")["frame"] = Value("alpha/base_link");
  EXPECT_THAT(errors(), Contains(HasSubstr("bravo/frame: found 'alpha/base_link', which is not its "
                                           "own")));
}

TEST_F(PlacementTest, NamesADistractorThatCannotBeSeen) {
  std::ofstream(run.folder() / "nothing.sdf")
      << "<sdf version='1.6'><model name='nothing'><link name='l'/></model></sdf>";
  Value::Map distractors = volumeOf({-1, -1, 1}, {1, 1, 2}, "fly");
  distractors["models"] = Value(Value::List{Value((run.folder() / "nothing.sdf").string())});
  parameters["randomize"] = Value(Value::Map{{"distractors", Value(distractors)}});
  EXPECT_THAT(errors(), Contains(AllOf(HasSubstr("randomize/distractors/models: found"),
                                       HasSubstr("a model without visible parts"))));
}

TEST_F(PlacementTest, NamesAFrameThatNothingHas) {
  group("bounding_shape")["output_frame"] = Value("alpha/base_lin");
  EXPECT_THAT(errors(), Contains(AllOf(
                            HasSubstr("a writer asks for the frame 'alpha/base_lin': the placement "
                                      "has no frame"),
                            HasSubstr("did you mean 'alpha/base_link'?"))));
}

TEST_F(PlacementTest, NamesACameraThatIsNowhere) {
  putCamera({});
  EXPECT_THAT(errors(),
              Contains(HasSubstr("camera: nothing says where it is; camera/pose should")));
}

TEST_F(PlacementTest, NamesAPlacementWithoutAMap) {
  placement({{"tries", Value(5)}});
  EXPECT_THAT(errors(), ::testing::ElementsAre(HasSubstr("placement/map: no map; it should name")));
}

TEST_F(PlacementTest, NamesWhatIsWrongWithSeveralSettingsAtOnce) {
  parameters.erase("scenes");
  parameters["start_offset"] = Value(1.0);
  placement({{"mode", Value("drop")}});
  EXPECT_THAT(errors(),
              AllOf(Contains(HasSubstr("scenes: ")), Contains(HasSubstr("start_offset: ")),
                    Contains(HasSubstr("placement/volume: "))));
}

TEST_F(PlacementTest, TellsOfASceneWithoutAPlace) {
  placement(volumeOf({-0.1, -0.1, 0.1}, {0.1, 0.1, 0.2}));
  group("placement")["tries"] = Value(50);
  try {
    (void)generate();
    FAIL() << "two boxes of 0.4 m in 0.2 m";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("placement: scene 0"), HasSubstr("no place for '")));
  }
}

}  // namespace placement_test
}  // namespace synthetic_dataset::run
