#include <cstring>

#include <gmock/gmock.h>

#include "plugins/plugin_harness.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset {
namespace semantic_kitti_writer_test {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class SemanticKitti : public PluginTest {
 protected:
  SemanticKitti() : PluginTest("synthetic_dataset/SemanticKitti") {
    addLidar();
    dataset_.classes = {{0, "car"}, {1, "van"}};
    dataset_.world_classes = {"road"};
    dataset_.motions = {{"walk", 0, 4, 5.0}};
    dataset_.global_frame = "map";
  }

  /// A scene with a car; the scanner is `x` metres ahead, and the camera beside it looks along x.
  [[nodiscard]] static Scene sceneAt(std::int64_t index, double x) {
    SceneObject car = seen("rover", {100, 80, 50, 40});
    Scene made = withCloud(scene(index, {car}));
    made.stamp = Stamp(std::chrono::milliseconds(1000 + 100 * index));
    Pose X_GS = Pose::Identity();
    X_GS.translation().x() = x;
    made.X_GC.linear() << 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0;
    made.X_GC.translation() = Eigen::Vector3d(x, 0.5, 0.0);
    made.setTransforms([X_GS](const std::string&, const std::string&) { return X_GS; });
    return made;
  }

  [[nodiscard]] std::string read(const std::string& path) const {
    return test::readFile(folder() + path);
  }

  [[nodiscard]] static std::vector<std::uint32_t> words(const std::string& bytes) {
    std::vector<std::uint32_t> result(bytes.size() / 4);
    std::memcpy(result.data(), bytes.data(), bytes.size());
    return result;
  }
};

TEST_F(SemanticKitti, HasAClassAndAnObjectForEachPoint) {
  load({});
  const auto files = filesOf(sceneAt(0, 0.0));
  EXPECT_THAT(words(files.at("scenes/00000000.label")), ElementsAre(0, 0x10001, 0x10001));
  EXPECT_EQ(files.at("scenes/00000000.bin").size(), 3U * 16U);
}

TEST_F(SemanticKitti, TakesTheNumbersThatAreSet) {
  load({{"class_ids", Value::Map{{"car", 10}, {"road", 1}}}});
  EXPECT_THAT(parameters_.errors(), IsEmpty());
  const auto files = filesOf(sceneAt(0, 0.0));
  EXPECT_THAT(words(files.at("scenes/00000000.label")), ElementsAre(0, 0x1000A, 0x1000A));
  runAll({sceneAt(0, 0.0)});
  EXPECT_THAT(read("semantic-kitti.yaml"),
              AllOf(HasSubstr("  0: \"unlabeled\"\n  1: \"road\"\n  2: \"van\"\n  10: \"car\"\n"),
                    HasSubstr("learning_map_inv:\n  0: 0\n  1: 1\n  2: 2\n  3: 10\n"),
                    HasSubstr("  10: 0.666666667\n"), HasSubstr("  train:\n    - 0\n")));
}

TEST_F(SemanticKitti, HasPosesOfTheCameraInItsFirstFrame) {
  load({});
  runAll({sceneAt(0, 2.0), sceneAt(1, 2.5)});
  // The scanner drives along x, which is the camera's z.
  EXPECT_THAT(read("sequences/00/poses.txt"),
              HasSubstr("\n1.000000000 0.000000000 0.000000000 0.000000000 0.000000000 1.000000000 "
                        "0.000000000 0.000000000 0.000000000 0.000000000 1.000000000 "
                        "0.500000000\n"));
  EXPECT_THAT(read("sequences/00/calib.txt"),
              HasSubstr("Tr: 0.000000000 -1.000000000 0.000000000 0.500000000 0.000000000 "
                        "0.000000000 -1.000000000 0.000000000 1.000000000 0.000000000 0.000000000 "
                        "0.000000000\n"));
  EXPECT_EQ(read("sequences/00/times.txt"), "0.000000000\n0.100000000\n");
  EXPECT_EQ(read("sequences/00/velodyne/000001.bin"), read("scenes/00000001.bin"));
  EXPECT_EQ(read("sequences/00/labels/000001.label"), read("scenes/00000001.label"));
}

TEST_F(SemanticKitti, WritesPointsAsMeasuredWhereAsked) {
  load({{"motion_corrected", false}});
  const std::string measured = filesOf(sceneAt(0, 0.0)).at("scenes/00000000.bin");
  load({});
  const std::string corrected = filesOf(sceneAt(0, 0.0)).at("scenes/00000000.bin");
  float x = 0.0F;
  std::memcpy(&x, measured.data(), sizeof x);
  EXPECT_EQ(x, 1.5F);
  std::memcpy(&x, corrected.data(), sizeof x);
  EXPECT_EQ(x, 1.25F);
}

TEST_F(SemanticKitti, HasASequenceForEachSplit) {
  dataset_.splits = {{"train", 1}, {"val", 1}};
  load({});
  Scene first = sceneAt(0, 0.0);
  Scene second = sceneAt(1, 1.0);
  first.split = "train";
  second.split = "val";
  runAll({first, second});
  EXPECT_EQ(read("sequences/01/times.txt"), "0.000000000\n");
  EXPECT_THAT(read("semantic-kitti.yaml"),
              HasSubstr("  train:\n    - 0\n  valid:\n    - 1\n  test: []\n"));
}

TEST_F(SemanticKitti, NamesClassesThatNobodyHas) {
  load({{"class_ids", Value::Map{{"cra", 10}, {"van", 0}}}});
  EXPECT_THAT(parameters_.errors(), AllOf(Contains(HasSubstr("did you mean 'car'?")),
                                          Contains(HasSubstr("w/class_ids/van"))));
}

TEST_F(SemanticKitti, NeedsALidar) {
  dataset_.lidars.clear();
  EXPECT_THROW(load({}), ErrorList);
}

TEST_F(SemanticKitti, AsksWhichOfSeveralLidars) {
  dataset_.lidars.push_back({"rear", "rear/lidar_link"});
  load({});
  EXPECT_THAT(parameters_.errors(), Contains(HasSubstr("w/lidar")));
}

}  // namespace semantic_kitti_writer_test
}  // namespace synthetic_dataset
