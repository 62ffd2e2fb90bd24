/// Runs whose scenes are relit and repainted, and runs of which only single scenes are made.

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "all_at_once_run.h"
#include "base/sqlite.h"
#include "base/yaml_value.h"
#include "run/merger.h"
#include "run_fixture.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace variation_test {

namespace fs = std::filesystem;
using test::AllAtOnceRun;
using test::StoppingReporter;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

using Files = std::map<std::string, std::string>;
using Draws = std::map<std::string, std::vector<double>>;  ///< of a scene, by name; empty for texts

Value yaml(const std::string& text) { return base::parseYaml(text, "test"); }

/// The number, or the numbers of a list; empty for a text.
std::vector<double> numbersOf(const Value& value) {
  if (const auto* number = value.as<double>()) return {*number};
  if (const auto* number = value.as<std::int64_t>()) return {static_cast<double>(*number)};
  std::vector<double> numbers;
  const auto* list = value.as<Value::List>();
  for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
    numbers.push_back(numbersOf((*list)[i]).at(0));
  }
  return numbers;
}

/// The manifest's table `draw`, scene by scene.
std::map<std::int64_t, Draws> drawsIn(const std::string& folder) {
  const base::SqliteDatabase manifest(folder + "/manifest.sqlite",
                                      base::SqliteDatabase::Mode::kReadOnly);
  base::SqliteStatement row(manifest, "SELECT scene, name, value FROM draw");
  std::map<std::int64_t, Draws> draws;
  // JSON is YAML.
  while (row.step()) draws[row.integer(0)][row.text(1)] = numbersOf(yaml(row.text(2)));
  return draws;
}

std::set<std::string> namesOf(const Draws& draws) {
  std::set<std::string> names;
  for (const auto& [name, numbers] : draws) names.insert(name);
  return names;
}

/// The scenes in the order of their drawn numbers, least first.
std::vector<std::int64_t> sortedBy(const std::string& name,
                                   const std::map<std::int64_t, Draws>& draws) {
  std::vector<std::int64_t> scenes;
  for (const auto& [scene, of_scene] : draws) scenes.push_back(scene);
  std::sort(scenes.begin(), scenes.end(), [&](std::int64_t a, std::int64_t b) {
    return draws.at(a).at(name) < draws.at(b).at(name);
  });
  return scenes;
}

// --- One camera, few formats ---

class Variation : public test::RunFixture {
 protected:
  Variation() {
    parameters.erase("background_subtractor");
    parameters["simulated_rate"] = Value(8.0);
  }

  void randomize(const std::string& text) { parameters["randomize"] = yaml(text); }

  /// The brightness of the floor in front of the camera, where nothing ever stands.
  [[nodiscard]] double floorIn(std::int64_t scene) const {
    const cv::Mat image = cv::imread(folder + "/yolo/0000000" + std::to_string(scene) + ".png");
    return cv::mean(image(cv::Rect(60, 105, 40, 14)))[1];
  }
};

TEST_F(Variation, IsToldInTheManifest) {
  randomize(
      "{lights: {sun: {intensity: {log_uniform: [0.3, 2]}, colour: {uniform: [[1, 0, 0], 1]}}}, "
      "materials: {floor: {textures: procedural}}, sensor: {blur: {uniform: [0, 2]}}}");
  (void)filesAnew();
  const auto draws = drawsIn(folder);
  ASSERT_EQ(draws.size(), 8U);
  std::set<double> intensities;
  for (const auto& [scene, of_scene] : draws) {
    EXPECT_THAT(namesOf(of_scene),
                ElementsAre("lights/sun/colour", "lights/sun/intensity",
                            "materials/floor/floor::body::slab/textures", "sensor/blur"));
    EXPECT_EQ(of_scene.at("lights/sun/colour").size(), 3U);
    EXPECT_EQ(of_scene.at("lights/sun/colour")[0], 1.0);
    const double intensity = of_scene.at("lights/sun/intensity").at(0);
    EXPECT_GE(intensity, 0.3);
    EXPECT_LE(intensity, 2.0);
    intensities.insert(intensity);
  }
  EXPECT_EQ(intensities.size(), 8U) << "each scene draws its own";
}

TEST_F(Variation, ShowsTheLightThatWasDrawn) {
  randomize("{lights: {sun: {intensity: {uniform: [0.2, 1.5]}}}}");
  (void)filesAnew();
  double before = 0.0;
  for (const std::int64_t scene : sortedBy("lights/sun/intensity", drawsIn(folder))) {
    EXPECT_GT(floorIn(scene), before + 0.2) << scene;
    before = floorIn(scene);
  }
}

TEST_F(Variation, OfTheExposureMakesPicturesBrighter) {
  randomize("{sensor: {exposure: {uniform: [-2, 2]}}}");
  (void)filesAnew();
  double before = 0.0;
  const auto draws = drawsIn(folder);
  const auto sorted = sortedBy("sensor/exposure", draws);
  for (const std::int64_t scene : sorted) {
    EXPECT_GT(floorIn(scene), before + 0.2) << scene;
    before = floorIn(scene);
  }
  EXPECT_GT(floorIn(sorted.back()), 2.0 * floorIn(sorted.front()));
}

TEST_F(Variation, OfTheNumberOfLightsIsTold) {
  randomize("{light_count: {choice: [0, 1]}}");
  (void)filesAnew();
  std::map<double, double> brightest;
  for (const auto& [scene, draws] : drawsIn(folder)) {
    EXPECT_THAT(namesOf(draws), ElementsAre("light_count", "lights/sun/present"));
    const double count = draws.at("light_count").at(0);
    EXPECT_EQ(draws.at("lights/sun/present").at(0), count);
    brightest[count] = std::max(brightest[count], floorIn(scene));
  }
  EXPECT_GT(brightest.at(1.0), brightest.at(0.0) + 30.0);
}

TEST_F(Variation, IsThatOfTheWorldsOwnLightWhereItIsDrawnSo) {
  const Files as_described = filesAnew();
  randomize("{lights: {sun: {intensity: 1, present: 1}}, sensor: {exposure: 0, blur: 0}}");
  Files made = filesAnew();
  for (const auto& [name, bytes] : as_described) {
    if (name == "manifest.sqlite") continue;
    EXPECT_TRUE(made[name] == bytes) << name;
  }
}

TEST_F(Variation, LeavesLabelsAndMasksAsTheyAre) {
  const Files plain = filesAnew();
  randomize(
      "{lights: {every: {intensity: {uniform: [0.1, 3]}, azimuth: {uniform: [-3, 3]}}}, ambient: "
      "{uniform: [0, 1]}, background: {uniform: [[0, 0, 0], 1]}, materials: {objects: {textures: "
      "procedural}, world: {colour: {uniform: [[0, 0, 0], 1]}}}, sensor: {exposure: {uniform: [-1, "
      "1]}, noise_stddev: {uniform: [0.01, 0.05]}, blur: {uniform: [0.5, 2]}, white_balance: "
      "{uniform: [4000, 6000]}, "
      "jpeg_quality: 60}, weather: "
      "{visibility: "
      "{uniform: [2, 20]}, rain: 30, snow: 2, dust: 0.1}}");
  Files varied = filesAnew();
  ASSERT_EQ(varied.size(), plain.size());
  int labels = 0;
  int pictures = 0;
  for (const auto& [name, bytes] : plain) {
    const bool is_picture =
        name.find("mask") == std::string::npos && fs::path(name).extension() == ".png";
    if (name == "manifest.sqlite") continue;
    (is_picture ? pictures : labels) += 1;
    EXPECT_EQ(varied[name] == bytes, !is_picture) << name;
  }
  EXPECT_GT(labels, 30);
  EXPECT_GE(pictures, 8);
}

TEST_F(Variation, FullLightLeavesLabelsAndSubtractedMasks) {
  parameters["masks"] = yaml("{method: mog2}");
  const Files simple = filesAnew();
  parameters["rendering"] = yaml("{light: full}");
  Files full = filesAnew();
  ASSERT_EQ(full.size(), simple.size());
  int darker = 0;
  for (const auto& [name, bytes] : simple) {
    const bool is_picture =
        name.find("mask") == std::string::npos && fs::path(name).extension() == ".png";
    if (name == "manifest.sqlite") continue;
    EXPECT_EQ(full[name] == bytes, !is_picture) << name;
    darker += is_picture ? 1 : 0;
  }
  EXPECT_GE(darker, 8);
}

TEST_F(Variation, OfOneEntryLeavesTheOthersDraws) {
  randomize(
      "{lights: {sun: {intensity: {uniform: [0, 2]}, azimuth: {uniform: [0, 3]}}}, ambient: "
      "{uniform: [0, 1]}, materials: {objects: {roughness: {uniform: [0, 1]}}}, sensor: {exposure: "
      "{uniform: [0, 1]}}}");
  (void)filesAnew();
  const auto before = drawsIn(folder);
  randomize(
      "{lights: {sun: {intensity: {normal: [1, 0.2]}}, every: {present: 0.5}}, ambient: {uniform: "
      "[0, 1]}, materials: {objects: {roughness: {uniform: [0, 1]}, textures: procedural}}, "
      "sensor: "
      "{exposure: {uniform: [0, 1]}, blur: {uniform: [0, 1]}}}");
  (void)filesAnew();
  auto after = drawsIn(folder);
  for (const auto& [scene, draws] : before) {
    for (const auto& [name, numbers] : draws) {
      if (name == "lights/sun/azimuth") {
        EXPECT_EQ(after[scene].count(name), 0U);
      } else if (name == "lights/sun/intensity") {
        EXPECT_NE(after[scene].at(name), numbers);
      } else {
        EXPECT_EQ(after[scene].at(name), numbers) << name << " of scene " << scene;
      }
    }
  }
}

/// The lines of label files about an object.
std::vector<std::string> linesAbout(const std::string& object, const Files& files) {
  std::vector<std::string> lines;
  for (const auto& [name, bytes] : files) {
    if (fs::path(name).extension() != ".txt") continue;
    std::istringstream text(bytes);
    for (std::string line; std::getline(text, line);) {
      if (line.rfind(object, 0) == 0) lines.push_back(line);
    }
  }
  return lines;
}

TEST_F(Variation, AnObjectThatIsAbsentHasNoLabelAndIsNotSeen) {
  const Files all = filesAnew();
  ASSERT_THAT(linesAbout("bravo", all), Not(IsEmpty()));
  randomize("{objects: {bravo: {present: 0}}}");
  Files without = filesAnew();
  EXPECT_THAT(linesAbout("bravo", without), IsEmpty());
  EXPECT_EQ(linesAbout("alpha", without), linesAbout("alpha", all));
  EXPECT_NE(without["yolo/00000003.png"], all.at("yolo/00000003.png"));
  for (const auto& [scene, draws] : drawsIn(folder)) {
    EXPECT_THAT(draws.at("objects/bravo/present"), ElementsAre(0.0)) << scene;
  }
}

TEST_F(Variation, DistractorsAreSeenAndHaveNoLabel) {
  const Files plain = filesAnew();
  randomize("{distractors: {count: 3, volume: {min: [-1, -1, 0.3], max: [1, 1, 1.5]}}}");
  Files crowded = filesAnew();
  EXPECT_EQ(linesAbout("", crowded).size(), linesAbout("", plain).size());
  EXPECT_EQ(linesAbout("alpha", crowded), linesAbout("alpha", plain));
  std::set<std::vector<double>> choices;
  for (const auto& [scene, draws] : drawsIn(folder)) {
    const std::string picture = "yolo/0000000" + std::to_string(scene) + ".png";
    EXPECT_NE(crowded[picture], plain.at(picture)) << scene;
    EXPECT_EQ(draws.at("distractors").size(), 3U) << scene;
    choices.insert(draws.at("distractors"));
  }
  EXPECT_GT(choices.size(), 4U);
}

/// The manifest's data of an object in a scene.
struct ObjectRow {
  bool in_view;
  bool dropped;
  std::optional<double> height;  ///< of its frame [m]; empty if it is not in the scene
};

/// The rows by scene and object name.
std::map<std::int64_t, std::map<std::string, ObjectRow>> objectsIn(const std::string& folder) {
  const base::SqliteDatabase manifest(folder + "/manifest.sqlite",
                                      base::SqliteDatabase::Mode::kReadOnly);
  base::SqliteStatement row(manifest,
                            "SELECT scene, name, in_view, dropped, z "
                            "FROM scene_object JOIN object ON object = object.\"index\"");
  std::map<std::int64_t, std::map<std::string, ObjectRow>> objects;
  while (row.step()) {
    objects[row.integer(0)][row.text(1)] = {
        row.integer(2) != 0, row.integer(3) != 0,
        row.isNull(4) ? std::nullopt : std::optional(row.real(4))};
  }
  return objects;
}

TEST_F(Variation, AnObjectThatIsAbsentIsNowhere) {
  randomize("{objects: {bravo: {present: 0.5}}}");
  (void)filesAnew();
  std::set<bool> met;
  const auto draws = drawsIn(folder);
  for (const auto& [scene, objects] : objectsIn(folder)) {
    const bool is_there = draws.at(scene).at("objects/bravo/present") == std::vector<double>{1.0};
    EXPECT_EQ(objects.at("bravo").height.has_value(), is_there) << scene;
    EXPECT_TRUE(objects.at("alpha").height.has_value()) << scene;
    met.insert(is_there);
  }
  EXPECT_EQ(met.size(), 2U);
}

TEST_F(Variation, AsManyObjectsAreThereAsAreDrawn) {
  randomize("{object_count: {choice: [0, 1, 2]}}");
  (void)filesAnew();
  std::set<double> counts;
  const auto draws = drawsIn(folder);
  for (const auto& [scene, objects] : objectsIn(folder)) {
    double there = 0.0;
    for (const auto& [name, object] : objects) there += object.height ? 1.0 : 0.0;
    EXPECT_THAT(draws.at(scene).at("object_count"), ElementsAre(there)) << scene;
    counts.insert(there);
  }
  EXPECT_GT(counts.size(), 1U);
}

TEST_F(Variation, DistractorsWithAClassAreLabelledWhereTheyAre) {
  const std::string distractors =
      "pool: 5, count: {uniform: [1, 4]}, volume: {min: [-1, -1, 0.3], max: [1, 1, 1.5]}";
  randomize("{distractors: {" + distractors + "}}");
  const Files unlabelled = filesAnew();
  randomize("{distractors: {" + distractors + ", class: clutter}}");
  const Files labelled = filesAnew();
  EXPECT_EQ(labelled.at("yolo/00000003.png"), unlabelled.at("yolo/00000003.png"));
  EXPECT_EQ(linesAbout("alpha", labelled), linesAbout("alpha", unlabelled));
  int seen = 0;
  const auto draws = drawsIn(folder);
  for (const auto& [scene, objects] : objectsIn(folder)) {
    ASSERT_EQ(objects.size(), 7U);
    const std::vector<double>& there = draws.at(scene).at("distractors");
    for (int number = 1; number <= 5; ++number) {
      const std::string name = "distractor_" + std::to_string(number);
      const ObjectRow& object = objects.at(name);
      const bool is_there = std::find(there.begin(), there.end(), number) != there.end();
      EXPECT_EQ(object.dropped, !is_there) << scene << ": " << name;
      EXPECT_TRUE(is_there || !object.in_view) << scene << ": " << name;
      ASSERT_EQ(object.height.has_value(), is_there) << scene << ": " << name;
      EXPECT_TRUE(!is_there || (*object.height > 0.3 && *object.height < 1.5));
      seen += object.in_view ? 1 : 0;
    }
  }
  EXPECT_GT(seen, 10);
}

TEST_F(Variation, ALabelledDistractorsNameIsItsOwn) {
  randomize("{distractors: {class: 7, volume: {min: [-1, -1, 0.3], max: [1, 1, 1.5]}}}");
  (*parameters["bravo"].as<Value::Map>())["id"] = Value("distractor_3");
  EXPECT_THAT(errors(), Contains(HasSubstr("robot_list: found an object with the name or id "
                                           "'distractor_3', which is that of a labelled")));
}

TEST_F(Variation, NamesEntriesThatMeanNothingBesideOtherErrors) {
  randomize("{lights: {snu: {intensity: 1}}, materials: {alphaa: {colour: 0.5}}, fog: 3}");
  parameters["simulated_rte"] = Value(3);
  EXPECT_THAT(errors(), Contains(HasSubstr("randomize/lights/snu: the world has no light")));
  EXPECT_THAT(errors(), Contains(HasSubstr("did you mean 'alpha'?")));
  EXPECT_THAT(errors(), Contains(HasSubstr("randomize/fog")));
  EXPECT_THAT(errors(), Contains(HasSubstr("simulated_rte")));
}

// --- Two cameras, many formats, masks by background subtraction ---

class VariedRun : public ::testing::Test {
 protected:
  VariedRun() {
    const std::string skies = run.input("skies");
    fs::create_directory(skies);
    for (const int shade : {0, 100, 200}) {
      cv::imwrite(skies + "/" + std::to_string(shade) + ".png",
                  cv::Mat(20, 40, CV_8UC3, cv::Scalar(shade, 150, 200)));
    }
    run.parameters["randomize"] = yaml(
        "{background: {pictures: '" + skies +
        "', projection: panorama, present: 0.7, yaw: "
        "{uniform: [-3, 3]}}, light_count: {choice: [0, 1], weights: [1, 4]}, "
        "lights: {sun: {intensity: {uniform: [0.2, 2]}, azimuth: {uniform: [-3, 3]}}}, ambient: "
        "{uniform: [0.1, 0.8]}, materials: {objects: {textures: procedural}, world: {for_each: "
        "model, colour: {uniform: [[0, 0, 0], 1]}}}, sensor: {exposure: {uniform: [-1, 1]}, "
        "noise_stddev: {uniform: [0, 0.03]}}, weather: {present: 0.8, visibility: {uniform: [3, "
        "30]}, "
        "rain: {uniform: [5, 50]}, snow: {uniform: [0, 2]}, dust: {uniform: [0.01, 0.1]}}, "
        "objects: {bravo: {present: 0.6}}, "
        "distractors: "
        "{class: clutter, mode: drop, pool: 8, count: {uniform: [0, 5]}, volume: {min: [-1, -1, "
        "0.3], max: [1, 1, 1.2]}}}");
  }

  /// Expects all files made so far to be among these.
  void expectScenesOf(const Files& expected) const {
    int files = 0;
    for (const auto& [name, bytes] : AllAtOnceRun::files(run.folder())) {
      if (name == "manifest.sqlite") continue;
      ++files;
      EXPECT_TRUE(expected.count(name) == 1 && expected.at(name) == bytes) << name;
    }
    EXPECT_GT(files, 10);
  }

  void only(const std::string& scenes) { run.parameters["only_scenes"] = yaml(scenes); }
  void all() { run.parameters.erase("only_scenes"); }

  AllAtOnceRun run;
};

TEST_F(VariedRun, HasAnExposureOfEachCamerasOwnAndALightForAll) {
  (void)run.run();
  const auto draws = drawsIn(run.folder());
  ASSERT_EQ(draws.size(), 16U);
  std::set<double> exposures;
  for (std::int64_t instant = 0; instant < 8; ++instant) {
    const Draws& left = draws.at(2 * instant);
    const Draws& right = draws.at(2 * instant + 1);
    EXPECT_EQ(left.at("lights/sun/intensity"), right.at("lights/sun/intensity"));
    for (const Draws* each : {&left, &right}) exposures.insert(each->at("sensor/exposure").at(0));
  }
  EXPECT_EQ(exposures.size(), 16U);
}

TEST_F(VariedRun, HasTheSameDustOnEachLensInTheWholeRecording) {
  (void)run.run();
  const auto draws = drawsIn(run.folder());
  ASSERT_EQ(draws.size(), 16U);
  std::set<double> left;
  std::set<double> right;
  for (std::int64_t instant = 0; instant < 8; ++instant) {
    left.insert(draws.at(2 * instant).at("weather/dust").at(0));
    right.insert(draws.at(2 * instant + 1).at("weather/dust").at(0));
  }
  EXPECT_EQ(left.size(), 1U);
  EXPECT_EQ(right.size(), 1U);
  EXPECT_NE(left, right);
}

TEST_F(VariedRun, GivesTheBytesOfAnUnbrokenOneWhenResumed) {
  const Files expected = run.unbroken();
  ASSERT_GT(expected.size(), 150U);
  StoppingReporter stopping(5);
  EXPECT_TRUE(run.run(stopping, run.folder()).stopped);
  EXPECT_LT(run.run().scenes, 16);
  run.expectFiles(expected);
}

TEST_F(VariedRun, GivesTheBytesOfASingleOneInShards) {
  const Files expected = run.unbroken();
  for (const int index : {1, 0}) (void)run.runShard(index, 2, run.folder());
  Reporter silent;
  mergeShards(run.folder(), {}, silent, {test::pluginXml()});
  run.expectFiles(expected);
}

TEST_F(VariedRun, GivesTheSameBytesWhereNothingIsKept) {
  const Files expected = run.unbroken();
  run.parameters["rendering"] = yaml("{reuse: false}");
  (void)run.run();
  run.expectFiles(expected);
}

TEST_F(VariedRun, MakesOneSceneByItself) {
  const Files expected = run.unbroken();
  only("[5]");
  EXPECT_EQ(run.run().scenes, 2) << "one a camera";
  expectScenesOf(expected);
  EXPECT_EQ(drawsIn(run.folder()).size(), 2U);
}

TEST_F(VariedRun, MakesOneScenePlacedAtRandomByItself) {
  run.parameters.erase("bag_file");
  run.parameters["motion"] = Value("placement");
  run.parameters["scenes"] = Value(6);
  run.parameters["placement"] =
      yaml("{mode: drop, volume: {min: [-0.5, -1, 0.6], max: [0.5, 0.5, 1.5]}}");
  const Files expected = run.unbroken();
  only("4");
  EXPECT_EQ(run.run().scenes, 2);
  expectScenesOf(expected);
}

TEST_F(VariedRun, IsCompletedByTheSameCommandWithoutOnlyScenes) {
  const Files expected = run.unbroken();
  only("[6, 2]");
  const RunSummary some = run.run();
  EXPECT_EQ(some.planned_scenes, 4);
  EXPECT_EQ(some.dataset_scenes, 4);
  only("3");
  EXPECT_EQ(run.run().dataset_scenes, 6);
  all();
  const RunSummary rest = run.run();
  EXPECT_FALSE(rest.was_complete);
  EXPECT_EQ(rest.scenes, 10);
  EXPECT_EQ(rest.dataset_scenes, 16);
  run.expectFiles(expected);
}

TEST_F(VariedRun, LeavesTheDatasetOpenEvenIfAllScenesAreChosen) {
  const Files expected = run.unbroken();
  only("[0, 1, 2, 3, 4, 5, 6, 7]");
  EXPECT_EQ(run.run().scenes, 16);
  EXPECT_LT(AllAtOnceRun::files(run.folder()).size(), expected.size()) << "no files of the whole";
  only("[0]");
  EXPECT_EQ(run.run().scenes, 0) << "it is there";
  all();
  const RunSummary rest = run.run();
  EXPECT_FALSE(rest.was_complete);
  EXPECT_EQ(rest.scenes, 0);
  run.expectFiles(expected);
}

TEST_F(VariedRun, ThatIsCompleteHasNothingToMake) {
  const Files expected = run.unbroken();
  (void)run.run();
  only("[0]");
  EXPECT_TRUE(run.run().was_complete);
  run.expectFiles(expected);
}

TEST_F(VariedRun, MakesTheScenesOfAShardThatAreChosen) {
  const Files expected = run.unbroken();
  only("[1, 6]");
  EXPECT_EQ(run.runShard(0, 2, run.folder()).scenes, 2);
  EXPECT_EQ(run.runShard(1, 2, run.folder()).scenes, 2);
  all();
  for (const int index : {0, 1}) (void)run.runShard(index, 2, run.folder());
  Reporter silent;
  mergeShards(run.folder(), {}, silent, {test::pluginXml()});
  run.expectFiles(expected);
}

TEST_F(VariedRun, NamesScenesThatItDoesNotHave) {
  only("[3, 8]");
  EXPECT_THAT(run.errors(), ElementsAre("only_scenes: found 8; this run's scenes are 0 to 7"));
  EXPECT_FALSE(fs::exists(run.folder()));
}

TEST_F(VariedRun, NamesWhatIsNoSceneNumber) {
  const std::string should =
      "; it should be a list of scenes' numbers, as their files' names have them";
  only("[3, -1]");
  EXPECT_THAT(run.errors(), ElementsAre("only_scenes: found [3, -1]" + should));
  only("[first]");
  EXPECT_THAT(run.errors(), ElementsAre("only_scenes: found [first]" + should));
  only("2.5");
  EXPECT_THAT(run.errors(), ElementsAre("only_scenes: found 2.5" + should));
  only("[]");
  EXPECT_THAT(
      run.errors(),
      ElementsAre("only_scenes: found an empty list; it should name scenes, or be left out"));
}

}  // namespace variation_test
}  // namespace synthetic_dataset::run
