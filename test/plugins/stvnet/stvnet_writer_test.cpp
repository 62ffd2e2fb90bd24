#include <sstream>

#include <gmock/gmock.h>

#include "plugins/plugin_harness.h"

namespace synthetic_dataset {
namespace stvnet_writer_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

class StvNet : public PluginTest {
 protected:
  StvNet() : PluginTest("synthetic_dataset/StvNet") {}

  [[nodiscard]] static SceneObject keyed(const std::string& name,
                                         const std::vector<Eigen::Vector3d>& keypoints_O) {
    SceneObject result = seen(name, {100, 100, 5, 5});
    result.keypoints_O = keypoints_O;
    const CameraModel camera = scene(0, {}).camera;
    for (const Eigen::Vector3d& p_O : keypoints_O) {
      result.keypoints.emplace_back().pixel = camera.project(*result.X_CO * p_O);
    }
    return result;
  }

  /// The label file of a scene with one object that has these keypoints.
  [[nodiscard]] std::string labelOf(const std::vector<Eigen::Vector3d>& keypoints_O) const {
    return filesOf(scene(0, {keyed("a", keypoints_O)})).at("a/labels/00000000.txt");
  }
};

TEST_F(StvNet, WritesIdAndKeypointsAsFractionsEachWithASpaceBehind) {
  load({});
  // At z = 10 m a metre is 50 px: (320, 240) and (320 + 64, 240 - 96) px.
  EXPECT_EQ(labelOf({{0.0, 0.0, 0.0}, {1.28, -1.92, 0.0}}),
            "a_id 0.50000 0.50000 0.60000 0.30000 \n");
}

TEST_F(StvNet, DividesByTheKeypointsOwnDepth) {
  load({});
  // z = 20 m: 25 px a metre, hence (320 + 32, 240 + 24) px.
  EXPECT_EQ(labelOf({{1.28, 0.96, 10.0}}), "a_id 0.55000 0.55000 \n");
}

TEST_F(StvNet, CountsFromTheImagesEdgeWhenAskedTo) {
  load({{"pixel_origin", "edge"}});
  // (320, 240) px, and half a pixel more: 320.5 / 640, 240.5 / 480.
  EXPECT_EQ(labelOf({{0.0, 0.0, 0.0}}), "a_id 0.50078 0.50104 \n");
}

TEST_F(StvNet, KeepsKeypointsOutsideTheImage) {
  load({});
  // 320 - 640 and 240 + 480 px.
  EXPECT_EQ(labelOf({{-12.8, 9.6, 0.0}}), "a_id -0.50000 1.50000 \n");
}

TEST_F(StvNet, PrintsANegativeZeroAsPrintfDoes) {
  load({});
  // u = 320 - 50 * 6.40001 = -0.0005 px, a fraction of -7.8e-7.
  EXPECT_EQ(labelOf({{-6.40001, 0.0, 0.0}}), "a_id -0.00000 0.50000 \n");
}

TEST_F(StvNet, WritesTheIdAloneWithoutKeypoints) {
  load({});
  EXPECT_EQ(labelOf({}), "a_id \n");
}

TEST_F(StvNet, GivesEveryObjectAFolderWithImageMaskAndLabel) {
  load({});
  EXPECT_THAT(filesOf(scene(3, {keyed("a", {}), keyed("b", {})})),
              ElementsAre(Pair("a/JPEGImages/00000003.png", "<image>"),
                          Pair("a/labels/00000003.txt", "a_id \n"),
                          Pair("a/mask/00000003.png", "<silhouette a>"),
                          Pair("b/JPEGImages/00000003.png", "<image>"),
                          Pair("b/labels/00000003.txt", "b_id \n"),
                          Pair("b/mask/00000003.png", "<silhouette b>")));
}

TEST_F(StvNet, WritesNothingForAnObjectOutOfView) {
  load({});
  SceneObject outside = keyed("a", {});
  outside.loose_box = Box{700.0, 0.0, 800.0, 100.0};
  EXPECT_THAT(filesOf(scene(0, {outside})), IsEmpty());
}

TEST_F(StvNet, LeavesOutAnObjectWithAKeypointBehindTheCameraAndWarns) {
  const output::WriterHost& host = load({});
  const Scene half_behind = scene(0, {keyed("a", {{0.0, 0.0, 0.0}, {0.0, 0.0, -10.5}})});
  EXPECT_THAT(filesOf(half_behind), IsEmpty());
  EXPECT_THAT(host.writeScene(half_behind).warnings,
              testing::Contains(HasSubstr("writer 'w': a: a keypoint is behind the camera")));
}

TEST_F(StvNet, WarnsOfAnotherNumberOfKeypointsThanItsLoaderTakes) {
  const output::WriterHost& host = load({});
  const auto warningsOf = [&](std::size_t count) {
    return host.writeScene(scene(0, {keyed("a", std::vector<Eigen::Vector3d>(count, {0, 0, 0}))}))
        .warnings;
  };
  EXPECT_THAT(warningsOf(9), IsEmpty());
  EXPECT_THAT(warningsOf(8), ElementsAre(HasSubstr("reads 9 keypoints of an object, and this one "
                                                   "has 8")));
}

TEST_F(StvNet, WritesNinePointsAsItsLoaderTakesThem) {
  load({});
  // data.py: line.split(' ')[1:19]
  std::istringstream label(labelOf(std::vector<Eigen::Vector3d>(9, {0.0, 0.0, 0.0})));
  std::vector<std::string> words;
  for (std::string word; std::getline(label, word, ' ');) words.push_back(word);
  ASSERT_GE(words.size(), 19U);
  for (std::size_t i = 1; i < 19; ++i) EXPECT_EQ(words[i], "0.50000");
}

TEST_F(StvNet, KeepsNamesThatArePathsAndMakesOthersOne) {
  load({});
  const auto folderOf = [&](const std::string& name) {
    const std::string file = filesOf(scene(0, {keyed(name, {})})).begin()->first;
    return file.substr(0, file.find("/JPEGImages"));
  };
  EXPECT_EQ(folderOf("fork lift"), "fork lift");
  EXPECT_EQ(folderOf("fleet/a"), "fleet/a");
  for (const std::string& name : {std::string(".."), std::string("a/../.."), std::string("/a"),
                                  std::string("a\nb"), std::string(300, 'n')}) {
    EXPECT_THAT(folderOf(name), testing::MatchesRegex("[a-z_.]+_[0-9a-f]+")) << name;
  }
}

TEST_F(StvNet, NeedsMasks) { EXPECT_TRUE(load({}).requirements().silhouettes); }

TEST_F(StvNet, IgnoresTheOriginalsTimeout) {
  load({{"tf_timeout", 1.0}});
  EXPECT_THAT(parameters_.unknownNames(), IsEmpty());
}

}  // namespace stvnet_writer_test
}  // namespace synthetic_dataset
