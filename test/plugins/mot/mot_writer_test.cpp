#include <gmock/gmock.h>

#include "plugins/plugin_harness.h"

namespace synthetic_dataset {
namespace mot_writer_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Mot : public PluginTest {
 protected:
  Mot() : PluginTest("synthetic_dataset/Mot") {
    dataset_.classes = {{0, "rover"}, {2, "fork lift"}};
    dataset_.motions = {{"walk", 0, 4, 5.0}};
  }

  [[nodiscard]] static Scene sceneOf(std::int64_t index, std::vector<SceneObject> objects) {
    objects.back().class_id = 2;
    return scene(index, std::move(objects));
  }

  [[nodiscard]] std::string read(const std::string& path) const {
    return test::readFile(folder() + path);
  }
};

TEST_F(Mot, NumbersFramesTracksAndPixelsFrom1) {
  load({});
  SceneObject half_hidden = seen("b", {100, 50, 20, 10});
  half_hidden.pixels.visible = 100;  // of 200
  // Pixels 10 to 39 and 20 to 59 are 11 to 40 and 21 to 60 in MOTChallenge's files.
  runAll({sceneOf(0, {seen("a", {10, 20, 30, 40}), half_hidden}),
          sceneOf(1, {object("a"), seen("b", {101, 50, 20, 10})})});
  EXPECT_EQ(read("train/camera/gt/gt.txt"),
            "1,1,11.000,21.000,30.000,40.000,1,1,1.000\n"
            "1,2,101.000,51.000,20.000,10.000,1,3,0.500\n"
            "2,2,102.000,51.000,20.000,10.000,1,3,1.000\n");
  EXPECT_EQ(read("train/camera/gt/labels.txt"), "rover\nunused_2\nfork lift\n");
  EXPECT_EQ(read("train/camera/img1/000002.jpg"), read("scenes/00000001.jpg"));
  EXPECT_EQ(read("frames.txt"),
            "train/camera 1 scenes/00000000.jpg\ntrain/camera 2 scenes/00000001.jpg\n");
}

TEST_F(Mot, SaysWhatTheSequenceIs) {
  load({{"image_format", "png"}});
  runAll({sceneOf(0, {object("a")}), sceneOf(1, {object("a")})});
  EXPECT_EQ(read("train/camera/seqinfo.ini"),
            "[Sequence]\nname=camera\nimDir=img1\nframeRate=5\nseqLength=2\nimWidth=640\n"
            "imHeight=480\nimExt=.png\n");
}

TEST_F(Mot, GivesEachSplitASequenceWithoutGaps) {
  dataset_.splits = {{"train", 1}, {"val", 2}};
  load({});
  std::vector<Scene> scenes;
  for (int i = 0; i < 3; ++i) {
    scenes.push_back(sceneOf(i, {seen("a", {10 + i, 20, 30, 40})}));
    scenes.back().split = i == 0 ? "train" : "val";
  }
  runAll(scenes);
  EXPECT_EQ(read("val/camera/gt/gt.txt"),
            "1,1,12.000,21.000,30.000,40.000,1,3,1.000\n"
            "2,1,13.000,21.000,30.000,40.000,1,3,1.000\n");
}

TEST_F(Mot, GivesEachMotionAndCameraASequence) {
  dataset_.cameras = {{"left", "l", camera()}, {"right", "r", camera()}};
  dataset_.motions = {{"walk", 0, 1, 5.0}, {"drive", 1, 1, 10.0}};
  load({});
  std::vector<Scene> scenes;
  for (int i = 0; i < 4; ++i) {
    scenes.push_back(sceneOf(i, {seen("a", {10, 20, 30, 40})}));
    scenes.back().camera_index = static_cast<std::size_t>(i % 2);
    scenes.back().instant = i / 2;
    scenes.back().name = (i % 2 == 0 ? "left/" : "right/") + std::to_string(i / 2);
  }
  runAll(scenes);
  EXPECT_THAT(read("train/drive_right/seqinfo.ini"), HasSubstr("frameRate=10\nseqLength=1"));
  EXPECT_EQ(read("frames.txt"),
            "train/walk_left 1 scenes/left/0.jpg\ntrain/walk_right 1 scenes/right/0.jpg\n"
            "train/drive_left 1 scenes/left/1.jpg\ntrain/drive_right 1 scenes/right/1.jpg\n");
}

TEST_F(Mot, LetsWhatIsDroppedCountNeitherWay) {
  load({});
  SceneObject dropped = seen("a", {10, 20, 30, 40});
  dropped.dropped = true;
  runAll({sceneOf(0, {dropped})});
  EXPECT_EQ(read("train/camera/gt/gt.txt"), "1,1,11.000,21.000,30.000,40.000,0,3,1.000\n");
}

TEST_F(Mot, TakesClassNumbersOfTheUsersChoice) {
  load({{"class_ids", Value::Map{{"rover", 3}, {"fork lift", 1}}}});
  runAll({sceneOf(0, {seen("a", {10, 20, 30, 40})})});
  EXPECT_THAT(read("train/camera/gt/gt.txt"), HasSubstr(",1,1,1.000\n"));
  EXPECT_EQ(read("train/camera/gt/labels.txt"), "fork lift\nunused_2\nrover\n");
  load({{"class_ids", Value::Map{{"rover", 0}}}});
  EXPECT_THAT(parameters_.errors(), ElementsAre(HasSubstr("w/class_ids/rover: found 0")));
}

TEST_F(Mot, WarnsWhereNothingCanBeTracked) {
  const output::WriterHost& recorded = load({});
  EXPECT_THAT(recorded.writeScene(sceneOf(0, {object("a")})).warnings, IsEmpty());
  dataset_.motions = {{"placed", 0, 4, 0.0}};
  const output::WriterHost& placed = load({});
  EXPECT_THAT(placed.writeScene(sceneOf(0, {object("a")})).warnings,
              ElementsAre(HasSubstr("nothing can be tracked")));
}

}  // namespace mot_writer_test
}  // namespace synthetic_dataset
