#include <cstdio>

#include <gmock/gmock.h>

#include "plugins/plugin_harness.h"

namespace synthetic_dataset {
namespace yolo_writer_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

class Yolo : public PluginTest {
 protected:
  Yolo() : PluginTest("synthetic_dataset/Yolo") {}

  [[nodiscard]] static SceneObject boxed(const std::string& name, const Box& box) {
    SceneObject result = object(name);
    result.loose_box = box;
    return result;
  }

  [[nodiscard]] Value::Map parameters() const {
    return {{"main_list", (folder_ / "lists/main.txt").string()}};
  }

  /// The label file of a scene with one object that has this box.
  [[nodiscard]] std::string labelOf(const Box& box) const {
    return filesOf(scene(0, {boxed("a", box)})).at("00000000.txt");
  }
};

TEST_F(Yolo, WritesClassCentreAndSizeAsFractions) {
  load(parameters());
  // Centre (160, 120), size 64 x 96 in an image of 640 x 480.
  EXPECT_EQ(labelOf({128.0, 72.0, 192.0, 168.0}), "a_class 0.25000 0.25000 0.10000 0.20000\n");
}

TEST_F(Yolo, RoundsToFiveDecimals) {
  load(parameters());
  // Centre (100.5, 50.25), size 1 x 0.5: 0.15703125, 0.1046875, 0.0015625, 0.00104166...
  EXPECT_EQ(labelOf({100.0, 50.0, 101.0, 50.5}), "a_class 0.15703 0.10469 0.00156 0.00104\n");
}

TEST_F(Yolo, WritesImageAndLabelsUnderTheScenesNumber) {
  load(parameters());
  EXPECT_THAT(filesOf(scene(12, {})),
              ElementsAre(Pair("00000012.png", "<image>"), Pair("00000012.txt", "")));
}

TEST_F(Yolo, KeepsTheOrderOfObjects) {
  load(parameters());
  const Box box{0.0, 0.0, 640.0, 480.0};
  EXPECT_EQ(filesOf(scene(0, {boxed("z", box), boxed("a", box)})).at("00000000.txt"),
            "z_class 0.50000 0.50000 1.00000 1.00000\n"
            "a_class 0.50000 0.50000 1.00000 1.00000\n");
}

TEST_F(Yolo, CutsBoxesToTheImage) {
  load(parameters());
  // What remains in the image: (0, 0) to (64, 48), and (576, 432) to (640, 480).
  EXPECT_EQ(labelOf({-100.0, -50.0, 64.0, 48.0}), "a_class 0.05000 0.05000 0.10000 0.10000\n");
  EXPECT_EQ(labelOf({576.0, 432.0, 900.0, 900.0}), "a_class 0.95000 0.95000 0.10000 0.10000\n");
}

TEST_F(Yolo, KeepsBoxesWholeWhenAskedTo) {
  Value::Map whole = parameters();
  whole["cut_to_image"] = false;
  load(whole);
  // Centre (0, 0), size 128 x 96.
  EXPECT_EQ(labelOf({-64.0, -48.0, 64.0, 48.0}), "a_class 0.00000 0.00000 0.20000 0.20000\n");
}

TEST_F(Yolo, LeavesOutWhatIsNotInView) {
  load(parameters());
  const SceneObject outside = boxed("outside", {700.0, 0.0, 800.0, 100.0});
  EXPECT_EQ(filesOf(scene(0, {outside, object("behind")})).at("00000000.txt"), "");
}

TEST_F(Yolo, LeavesOutWhatReachesOnlyTheFirstPixelsOuterHalf) {
  load(parameters());
  EXPECT_EQ(labelOf({-20.0, 10.0, -0.25, 20.0}), "");
}

TEST_F(Yolo, CountsFromTheImagesEdgeWhenAskedTo) {
  Value::Map edge = parameters();
  edge["pixel_origin"] = "edge";
  load(edge);
  // Around the middle of the image, (319.5, 239.5) with pixel centres at whole numbers.
  EXPECT_EQ(labelOf({287.5, 191.5, 351.5, 287.5}), "a_class 0.50000 0.50000 0.10000 0.20000\n");
  EXPECT_EQ(labelOf({-20.5, -0.5, 63.5, 47.5}), "a_class 0.05000 0.05000 0.10000 0.10000\n");
}

TEST_F(Yolo, RefusesAnotherOrigin) {
  Value::Map corner = parameters();
  corner["pixel_origin"] = "corner";
  load(corner);
  EXPECT_THAT(parameters_.errors(), ElementsAre(HasSubstr("pixel_origin: found 'corner'")));
}

TEST_F(Yolo, ListsAllImagesInSceneOrder) {
  load(parameters());
  runAll({scene(1, {}), scene(0, {}), scene(10, {})});
  EXPECT_EQ(
      test::readFile(folder_ / "lists/main.txt"),
      folder() + "00000000.png\n" + folder() + "00000001.png\n" + folder() + "00000010.png\n");
}

TEST_F(Yolo, WritesWhatDarknetsDataFileNames) {
  dataset_.classes = {{0, "rover"}, {2, "fork lift"}};
  load(parameters());
  runAll({scene(0, {}), scene(1, {})});
  EXPECT_EQ(test::readFile(folder() + "obj.names"), "rover\nunused_1\nfork lift\n");
  EXPECT_EQ(test::readFile(folder() + "obj.data"),
            "classes = 3\ntrain = " + folder() + "train.txt\nvalid = " + folder() +
                "train.txt\nnames = " + folder() + "obj.names\nbackup = backup\n");
  EXPECT_EQ(test::readFile(folder() + "train.txt"),
            folder() + "00000000.png\n" + folder() + "00000001.png\n");
}

TEST_F(Yolo, ListsEachSplit) {
  dataset_.splits = {{"train", 1}, {"val", 1}};
  load(parameters());
  Scene second = scene(1, {});
  Scene first = scene(0, {});
  first.split = "train";
  second.split = "val";
  runAll({first, second});
  EXPECT_EQ(test::readFile(folder() + "train.txt"), folder() + "00000000.png\n");
  EXPECT_EQ(test::readFile(folder() + "val.txt"), folder() + "00000001.png\n");
  EXPECT_THAT(test::readFile(folder() + "obj.data"),
              HasSubstr("\nvalid = " + folder() + "val.txt\n"));
}

TEST_F(Yolo, LetsTheMainListBeTheOnlySplitsOne) {
  load({{"main_list", "train.txt"}});
  runAll({scene(0, {})});
  EXPECT_EQ(test::readFile(folder() + "train.txt"), folder() + "00000000.png\n");
}

TEST_F(Yolo, RefusesAMainListInThePlaceOfAnotherList) {
  load({{"main_list", "obj.names"}});
  EXPECT_THAT(parameters_.errors(), ElementsAre(HasSubstr("puts another file for Darknet")));
  dataset_.splits = {{"train", 1}, {"val", 1}};
  load({{"main_list", "val.txt"}});
  EXPECT_THAT(parameters_.errors(), ElementsAre(HasSubstr("puts another file for Darknet")));
}

/// How many labels Darknet reads from a file, as in read_boxes of its data.c.
int readByDarknet(const std::string& labels) {
  std::FILE* file = std::tmpfile();
  std::fputs(labels.c_str(), file);
  std::rewind(file);
  int id = 0;
  int count = 0;
  float x = 0.0F;
  float y = 0.0F;
  float w = 0.0F;
  float h = 0.0F;
  while (std::fscanf(file, "%d %f %f %f %f", &id, &x, &y, &w, &h) == 5) ++count;
  std::fclose(file);
  return count;
}

TEST_F(Yolo, WritesNumbersThatDarknetReads) {
  Value::Map numbers = parameters();
  numbers["class"] = "number";
  const output::WriterHost& host = load(numbers);
  SceneObject first = boxed("a", {0.0, 0.0, 640.0, 480.0});
  SceneObject second = boxed("b", {0.0, 0.0, 64.0, 48.0});
  first.class_id = 2;
  const Scene both = scene(0, {first, second});
  const std::string labels = filesOf(both).at("00000000.txt");
  EXPECT_EQ(labels,
            "2 0.50000 0.50000 1.00000 1.00000\n"
            "0 0.05000 0.05000 0.10000 0.10000\n");
  EXPECT_EQ(readByDarknet(labels), 2);
  EXPECT_THAT(host.writeScene(both).warnings, IsEmpty());
}

TEST_F(Yolo, WarnsOfTextsOfWhichDarknetReadsNone) {
  const output::WriterHost& host = load(parameters());
  const Scene text = scene(0, {boxed("a", {0.0, 0.0, 640.0, 480.0})});
  EXPECT_EQ(readByDarknet(filesOf(text).at("00000000.txt")), 0);
  EXPECT_THAT(host.writeScene(text).warnings, ElementsAre(HasSubstr("needs `class: number`")));
  EXPECT_THAT(host.writeScene(scene(1, {})).warnings, IsEmpty());
  Scene digits = text;
  digits.objects[0].class_text = "7";
  EXPECT_EQ(readByDarknet(filesOf(digits).at("00000000.txt")), 1);
  EXPECT_THAT(host.writeScene(digits).warnings, IsEmpty());
}

TEST_F(Yolo, NeedsNoMasks) { EXPECT_FALSE(load(parameters()).requirements().silhouettes); }

TEST_F(Yolo, NeedsAMainList) {
  load({});
  EXPECT_THAT(parameters_.errors(), ElementsAre(HasSubstr("w/main_list: required")));
}

TEST_F(Yolo, RefusesAMainListInThePlaceOfAScenesFile) {
  load({{"main_list", "00000012.txt"}});
  EXPECT_THAT(parameters_.errors(), ElementsAre(HasSubstr("where a scene's files go")));
  dataset_.cameras = {{"left", "left_link", camera()}, {"right", "right_link", camera()}};
  load({{"main_list", "left"}});
  EXPECT_THAT(parameters_.errors(), ElementsAre(HasSubstr("where a scene's files go")));
  load({{"main_list", "lists/all_00000012.txt"}});
  EXPECT_THAT(parameters_.errors(), IsEmpty());
}

TEST_F(Yolo, IgnoresTheOriginalsTimeout) {
  Value::Map old = parameters();
  old["tf_timeout"] = 1.0;
  load(old);
  EXPECT_THAT(parameters_.errors(), IsEmpty());
  EXPECT_THAT(parameters_.unknownNames(), IsEmpty());
}

}  // namespace yolo_writer_test
}  // namespace synthetic_dataset
