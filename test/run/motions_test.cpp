/// The contents of datasets of several motions.

#include <algorithm>
#include <cmath>
#include <sstream>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "motions_run.h"
#include "output/verify/dataset_verifier.h"

namespace synthetic_dataset::run {
namespace motions_test {

using test::ListedScene;
using test::MotionsRun;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

using Files = std::map<std::string, std::string>;

constexpr char kPlaced[] =
    "motion: placement, placement: {mode: volume, volume: {min: [-0.5, -1, 0.3], max: [0.5, 1, "
    "1]}}";

class MotionsTest : public ::testing::Test {
 protected:
  /// Writes COCO only, for which visible pixels are counted.
  void useCoco() {
    for (const char* name : {"yolo", "bounding_shape"}) run.parameters.erase(name);
    run.set("writers", "[{name: coco, type: synthetic_dataset/Coco}]");
  }

  [[nodiscard]] std::vector<std::string> problems() const {
    struct Listener : output::VerificationListener {
      void problem(const std::string& line) override { problems.push_back(line); }
      void remark(const std::string& /*line*/) override {}
      void progress(std::int64_t /*scene_count*/, std::int64_t /*of*/) override {}
      std::vector<std::string> problems;
    } listener;
    (void)output::verifyDataset(run.folder(), output::VerificationDepth::kLabels, listener);
    return listener.problems;
  }

  /// The splits of all scenes: `tttvv`.
  [[nodiscard]] std::string splits() const {
    std::string initials;
    for (const ListedScene& scene : run.scenes()) initials += scene.split.substr(0, 1);
    return initials;
  }

  /// The times of all scenes [ms].
  [[nodiscard]] std::vector<std::int64_t> times() const {
    std::vector<std::int64_t> times;
    for (const ListedScene& scene : run.scenes()) times.push_back(scene.milliseconds);
    return times;
  }

  MotionsRun run;
};

/// The files with the scene numbers in their names raised; files without one, such as lists, are
/// left out.
Files shifted(const Files& files, std::int64_t by) {
  Files result;
  for (const auto& [name, bytes] : files) {
    const std::size_t at = name.find("0000");
    if (at == std::string::npos) continue;
    const std::int64_t scene = std::stoll(name.substr(at, 8));
    result[name.substr(0, at) + MotionsRun::number(scene + by) + name.substr(at + 8)] = bytes;
  }
  return result;
}

/// The files of scenes from one number on, up to another.
Files filesOf(const Files& files, std::int64_t begin, std::int64_t end) {
  Files result;
  for (const auto& [name, bytes] : shifted(files, 0)) {
    const std::int64_t scene = std::stoll(name.substr(name.find("0000"), 8));
    if (scene >= begin && scene < end) result[name] = bytes;
  }
  return result;
}

/// The names of files that differ.
std::vector<std::string> differences(const Files& a, const Files& b) {
  std::vector<std::string> names;
  for (const auto& [name, bytes] : a) {
    if (b.count(name) == 0 || b.at(name) != bytes) names.push_back(name);
  }
  for (const auto& [name, bytes] : b) {
    if (a.count(name) == 0) names.push_back(name);
  }
  return names;
}

/// Lines about an object in the BoundingShape files of scenes.
int linesAbout(const std::string& object, const Files& files) {
  int lines = 0;
  for (const auto& [name, bytes] : files) {
    if (name.rfind("bounding_shape/", 0) != 0) continue;
    std::istringstream text(bytes);
    for (std::string line; std::getline(text, line);) lines += line.rfind(object, 0) == 0 ? 1 : 0;
  }
  return lines;
}

// --- One numbering ---

TEST_F(MotionsTest, AreNumberedThrough) {
  run.list("[{name: drive}, {bag_file: DIR/other.bag}, {name: put, scenes: 3, " +
           std::string(kPlaced) + "}]");
  const Files files = run.files();
  EXPECT_THAT(run.motions(),
              ElementsAre(test::ListedMotion{"drive", 0, 4}, test::ListedMotion{"1", 4, 2},
                          test::ListedMotion{"put", 6, 3}));
  EXPECT_THAT(times(), ElementsAre(1000, 1250, 1500, 1750, 5000, 5250, 250, 500, 750));
  const std::vector<ListedScene> scenes = run.scenes();
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    EXPECT_EQ(scenes[i].instant, static_cast<std::int64_t>(i));
    EXPECT_EQ(files.count("yolo/" + MotionsRun::number(static_cast<std::int64_t>(i)) + ".png"), 1U);
  }
  EXPECT_EQ(files.count("yolo/00000009.png"), 0U);
  const std::string& list = files.at("yolo/list.txt");
  EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), 9);
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(MotionsTest, ARunWithoutAListIsOneOfItself) {
  (void)run.run();
  EXPECT_THAT(run.motions(), ElementsAre(test::ListedMotion{"0", 0, 4}));
}

TEST_F(MotionsTest, AreToldAtTheStart) {
  struct Listener : Reporter {
    void info(const std::string& message) override { said.push_back(message); }
    std::vector<std::string> said;
  } listener;
  run.list("[{name: drive}, {name: put, scenes: 3, " + std::string(kPlaced) + "}]");
  (void)run.run(listener);
  EXPECT_THAT(listener.said, Contains("7 scenes of 2 motions"));
  EXPECT_THAT(listener.said, Contains("motion 'drive': numbers 0 to 3, recorded from 1.000 s on"));
  EXPECT_THAT(listener.said, Contains("motion 'put': numbers 4 to 6, placed"));
}

// --- Each as if it were alone ---

struct Alone {
  const char* name;
  const char* settings;  ///< of the entry, beside its name
};

class MotionAlone : public MotionsTest, public ::testing::WithParamInterface<Alone> {};

TEST_P(MotionAlone, HasTheSameFilesButForTheirNumbers) {
  run.list("[{name: first}, {" + std::string(GetParam().settings) + "}, {name: last}]");
  const Files all = run.files();
  const auto second = run.motions()[1];
  ASSERT_GE(second.instant_count, 2);
  run.parameters.erase("motions");
  const Files first = run.files();
  EXPECT_THAT(differences(filesOf(all, 0, 4), shifted(first, 0)), IsEmpty());
  // The world starts again: things fall as they did before.
  const std::int64_t end = 4 + second.instant_count;
  EXPECT_THAT(differences(filesOf(all, end, end + 4), shifted(first, end)), IsEmpty());
  run.list("[{" + std::string(GetParam().settings) + "}]");
  const Files alone = run.files();
  EXPECT_THAT(differences(filesOf(all, 4, end), shifted(alone, 4)), IsEmpty());
  EXPECT_THAT(differences(filesOf(alone, 0, 2), filesOf(first, 0, 2)), Not(IsEmpty()))
      << "it is another one";
}

INSTANTIATE_TEST_SUITE_P(
    Motions, MotionAlone,
    ::testing::Values(Alone{"Recording", "bag_file: DIR/other.bag"},
                      Alone{"World", "world: DIR/yard.world"},
                      Alone{"Camera", "camera: {info_file: DIR/wide.yaml}"},
                      Alone{"Pose", "camera: {pose: [-3, 0.5, 1, -0.5, 0.5, -0.5, 0.5]}"},
                      Alone{"Rate", "simulated_rate: 3"}, Alone{"Window", "start_offset: 0.4"},
                      Alone{"Settled", "physics: {settle: 1}"},
                      Alone{"All",
                            "bag_file: DIR/other.bag, world: DIR/yard.world, simulated_rate: "
                            "10, camera: {info_file: DIR/wide.yaml}"}),
    [](const auto& each) { return std::string(each.param.name); });

TEST_F(MotionsTest, EqualOnesAreDrawnOtherwise) {
  run.set("randomize", "{sensor: {exposure: {uniform: [-1, 1]}}}");
  run.list("[{}, {}]");
  const Files files = run.files();
  const Files again = shifted(filesOf(files, 4, 8), -4);
  const std::vector<std::string> others = differences(filesOf(files, 0, 4), again);
  EXPECT_THAT(others, Contains("yolo/00000000.png"));
  EXPECT_THAT(others, Contains("yolo/00000003.png"));
  EXPECT_THAT(others, Each(HasSubstr(".png"))) << "labels stay";
}

TEST_F(MotionsTest, MayBeDrawnEachInItsOwnWay) {
  run.list("[{}, {randomize: {sensor: {exposure: 1}}}]");
  const Files files = run.files();
  const Files brighter = shifted(filesOf(files, 4, 8), -4);
  EXPECT_THAT(differences(filesOf(files, 0, 4), brighter), Contains("yolo/00000003.png"));
  run.parameters.erase("motions");
  EXPECT_THAT(differences(filesOf(files, 0, 4), shifted(run.files(), 0)), IsEmpty());
}

TEST_F(MotionsTest, MayHaveImagesOfDifferentSizes) {
  run.set("writers",
          "[{name: yolo, type: synthetic_dataset/Yolo}, {name: coco, type: synthetic_dataset/Coco},"
          " {name: voc, type: synthetic_dataset/PascalVoc}]");
  run.parameters.erase("bounding_shape");
  run.list("[{}, {camera: {info_file: DIR/wide.yaml}}]");
  (void)run.run();
  const std::vector<ListedScene> scenes = run.scenes();
  ASSERT_THAT(scenes, SizeIs(8));
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const cv::Mat image = cv::imread(run.folder() + "/yolo/" +
                                     MotionsRun::number(static_cast<std::int64_t>(i)) + ".png");
    EXPECT_EQ(image.size(), i < 4 ? cv::Size(160, 120) : cv::Size(320, 100)) << i;
    EXPECT_EQ(cv::Size(scenes[i].width, scenes[i].height), image.size()) << i;
  }
  EXPECT_THAT(problems(), IsEmpty());
}

// --- How many scenes of each ---

TEST_F(MotionsTest, ShareAsManyScenesAsThereAreByTheirWeights) {
  run.list("[{weight: 1}, {bag_file: DIR/other.bag, weight: 2}]");
  (void)run.run();
  EXPECT_THAT(times(), ElementsAre(1000, 5000, 5250)) << "the second one has two";
}

TEST_F(MotionsTest, ShareTheNumberOfScenesThatIsGiven) {
  run.set("simulated_rate", "20");
  run.set("scenes", "12");
  run.list("[{weight: 2}, {weight: 1, " + std::string(kPlaced) + "}]");
  (void)run.run();
  // Of twenty times, every second or third is taken, from the first to nearly the last.
  EXPECT_THAT(times(), ElementsAre(1000, 1100, 1250, 1350, 1500, 1600, 1750, 1850,  //
                                   50, 100, 150, 200));
}

TEST_F(MotionsTest, ShareScenesEquallyWithoutWeights) {
  run.set("scenes", "4");
  run.list("[{}, {bag_file: DIR/other.bag}]");
  (void)run.run();
  EXPECT_THAT(times(), ElementsAre(1000, 1500, 5000, 5250));
}

TEST_F(MotionsTest, GiveThinnedOutScenesTheLabelsThatTheyHaveAmongAll) {
  const Files all = run.files();
  run.set("scenes", "2");
  run.list("[{}]");
  const Files some = run.files();
  for (const auto& [name, bytes] : filesOf(some, 0, 2)) {
    const std::string other = name.find("00000000") != std::string::npos ? "00000000" : "00000002";
    std::string before = name;
    EXPECT_EQ(all.at(before.replace(before.find("0000"), 8, other)), bytes) << name;
  }
}

// --- Splits ---

TEST_F(MotionsTest, AreDividedOneByOne) {
  run.set("split", "{train: 0.5, val: 0.5}");
  run.list("[{}, {bag_file: DIR/other.bag}]");
  (void)run.run();
  EXPECT_EQ(splits(), "ttvvtv");
}

TEST_F(MotionsTest, MayBeInOneSplitAsAWhole) {
  run.set("split", "{train: 0.5, val: 0.5}");
  run.list("[{}, {bag_file: DIR/other.bag, split: val}]");
  (void)run.run();
  EXPECT_EQ(splits(), "ttvvvv");
}

TEST_F(MotionsTest, MayAllNameTheirSplits) {
  run.list("[{split: val}, {bag_file: DIR/other.bag, split: train}]");
  (void)run.run();
  EXPECT_EQ(splits(), "vvvvtt");
}

// --- Optical flow ---

TEST_F(MotionsTest, EndWithAnUnknownFlow) {
  for (const char* name : {"yolo", "bounding_shape"}) run.parameters.erase(name);
  run.set("writers", "[{name: folder, type: synthetic_dataset/ImageFolder}]");
  run.set("folder", "{optical_flow: true}");
  run.list("[{}, {bag_file: DIR/other.bag}, {scenes: 2, " + std::string(kPlaced) + "}]");
  const Files files = run.files();
  std::string known;
  for (const auto& [name, bytes] : files) {
    if (name.find("flow_u") == std::string::npos) continue;
    const cv::Mat flow = cv::imread(run.folder() + "/" + name, cv::IMREAD_UNCHANGED);
    ASSERT_EQ(flow.type(), CV_32FC1) << name;
    const bool is_known = std::any_of(flow.begin<float>(), flow.end<float>(),
                                      [](float each) { return !std::isnan(each); });
    known += is_known ? "k" : "-";
  }
  EXPECT_EQ(known, "kkk-k---");
}

// --- Objects that do not take part ---

TEST_F(MotionsTest, MayLeaveAnObjectOut) {
  // The object is neither in this recording nor in this world.
  run.list("[{}, {robot_list: [alpha], bag_file: DIR/lone.bag, world: DIR/lone.world}]");
  const Files files = run.files();
  EXPECT_EQ(linesAbout("bravo", filesOf(files, 0, 4)), 4);
  EXPECT_EQ(linesAbout("bravo", filesOf(files, 4, 8)), 0);
  EXPECT_EQ(linesAbout("alpha", filesOf(files, 4, 8)), 4);
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(MotionsTest, ShowAnObjectOfTheWorldOnlyWhereItTakesPart) {
  run.list("[{robot_list: [alpha]}, {world: DIR/lone.world, robot_list: [alpha]}, {}]");
  const Files files = run.files();
  EXPECT_THAT(differences(filesOf(files, 0, 4), shifted(filesOf(files, 4, 8), -4)), IsEmpty());
  EXPECT_THAT(differences(filesOf(files, 0, 4), shifted(filesOf(files, 8, 12), -8)),
              Contains("yolo/00000003.png"));
}

TEST_F(MotionsTest, HaveNothingFallOnAnObjectThatDoesNotTakePart) {
  run.list(
      "[{bag_file: DIR/below.bag, robot_list: [alpha]}, {robot_list: [alpha]}, "
      "{bag_file: DIR/below.bag}]");
  const Files files = run.files();
  EXPECT_THAT(differences(filesOf(files, 0, 4), shifted(filesOf(files, 4, 8), -4)), IsEmpty());
  // Where the ball lies on bravo, 0.5 m above the floor.
  const auto onBravo = [&](const std::string& scene) {
    return cv::imread(run.folder() + "/yolo/" + scene + ".png").at<cv::Vec3b>(59, 122);
  };
  EXPECT_EQ(onBravo("00000003"), onBravo("00000007"));
  EXPECT_NE(onBravo("00000003"), onBravo("00000011"));
}

TEST_F(MotionsTest, LetAnObjectHaveTheFrameOfOneThatDoesNotTakePart) {
  run.list(
      "[{bag_file: DIR/other.bag}, {bag_file: DIR/other.bag, robot_list: [alpha], alpha: "
      "{frame: bravo/base_link}}, {scenes: 2, robot_list: [alpha], alpha: {frame: "
      "bravo/base_link}, " +
      std::string(kPlaced) + "}]");
  const Files files = run.files();
  const auto centre = [&](std::int64_t scene, const std::string& object) {
    std::istringstream text(files.at("bounding_shape/" + MotionsRun::number(scene) + ".txt"));
    for (std::string line; std::getline(text, line);) {
      if (line.rfind(object, 0) == 0) return line.substr(object.size());
    }
    return std::string("nowhere");
  };
  EXPECT_NE(centre(0, "bravo"), "nowhere");
  EXPECT_EQ(centre(2, "alpha"), centre(0, "bravo")) << "it is where bravo was";
  EXPECT_EQ(centre(3, "alpha"), centre(1, "bravo"));
  EXPECT_NE(centre(4, "alpha"), "nowhere");
}

TEST_F(MotionsTest, KeepNoPlaceForAnObjectThatDoesNotTakePart) {
  run.list("[{}, {scenes: 2, robot_list: [alpha], bravo: {safety_radius: 9}, " +
           std::string(kPlaced) + "}]");
  EXPECT_EQ(run.run().scenes, 6) << "with it there would be no place for alpha";
}

TEST_F(MotionsTest, AimCamerasAtWhatTakesPart) {
  useCoco();
  run.list("[{}, {scenes: 8, robot_list: [bravo], camera: {sample: {look_at: any, distance: 2}}, " +
           std::string(kPlaced) + "}]");
  (void)run.run();
  const Files files = run.files();
  EXPECT_THAT(problems(), IsEmpty());
  for (std::int64_t scene = 4; scene < 12; ++scene) {
    const cv::Mat image =
        cv::imread(run.folder() + "/coco/images/" + MotionsRun::number(scene) + ".png");
    const cv::Vec3b middle = image.at<cv::Vec3b>(60, 80);
    EXPECT_GT(middle[0], middle[2] + 20) << "bravo is blue: scene " << scene;
  }
}

TEST_F(MotionsTest, AimCamerasAtWhatTakesPartWhereAllOfThatIsAbsent) {
  run.set("randomize", "{objects: {every: {present: 0}}}");
  run.list("[{}, {scenes: 4, robot_list: [bravo], camera: {sample: {look_at: all}}, " +
           std::string(kPlaced) + "}]");
  EXPECT_EQ(run.run().scenes, 8) << "alpha is where no camera finds a place";
}

TEST_F(MotionsTest, HaveTheModelOfAnObjectThatTakesPartLater) {
  for (const char* name : {"yolo", "bounding_shape"}) run.parameters.erase(name);
  run.set("writers", "[{name: bop, type: synthetic_dataset/Bop}]");
  run.list("[{robot_list: [alpha], world: DIR/lone.world}, {}]");
  const Files files = run.files();
  ASSERT_EQ(files.count("bop/models/obj_000002.ply"), 1U);
  EXPECT_EQ(files.at("bop/models/obj_000002.ply").size(),
            files.at("bop/models/obj_000001.ply").size())
      << "both are boxes";
  EXPECT_THAT(problems(), IsEmpty());
}

}  // namespace motions_test
}  // namespace synthetic_dataset::run
