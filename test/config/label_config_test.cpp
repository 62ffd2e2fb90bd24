#include "config/readers.h"

#include <gmock/gmock.h>

#include "base/yaml_value.h"

namespace synthetic_dataset::config {
namespace label_config_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

Parameters settings(const std::string& yaml) { return Parameters(base::parseYaml(yaml, "test")); }

scene::ObjectOptions objectOf(const std::string& name, const std::string& class_name) {
  scene::ObjectOptions object;
  object.name = name;
  object.class_text = object.class_name = class_name;
  return object;
}

/// The classes that are made of these objects, in the form "0 rover, 1 drone".
std::string classesOf(Parameters root, std::vector<scene::ObjectOptions>& objects) {
  std::string text;
  for (const ClassConfig& each : readClasses(root, objects)) {
    text += (text.empty() ? "" : ", ") + std::to_string(each.id) + " " + each.name;
  }
  return text;
}

TEST(ReadMasks, TakesSubtractionWhereItIsSetUp) {
  EXPECT_EQ(readMasks(settings("{}")).method, label::MaskMethod::kExact);
  EXPECT_EQ(readMasks(settings("background_subtractor: {history_length: 1}")).method,
            label::MaskMethod::kMog2);
}

TEST(ReadMasks, TheMethodCanBeChosen) {
  EXPECT_EQ(readMasks(settings("masks: {method: mog2}")).method, label::MaskMethod::kMog2);
  EXPECT_EQ(readMasks(settings("{masks: {method: exact}, background_subtractor: {}}")).method,
            label::MaskMethod::kExact);
}

TEST(ReadMasks, RefusesAnotherMethod) {
  Parameters root = settings("masks: {method: magic}");
  (void)readMasks(root);
  EXPECT_THAT(root.errors(),
              ElementsAre("masks/method: found 'magic'; it should be exact or mog2"));
}

TEST(ReadLabels, HasNoThresholdsUnlessTheyAreSet) {
  EXPECT_FALSE(readLabels(settings("{}")).hasThresholds());
  EXPECT_TRUE(readLabels(settings("labels: {min_pixels: 12}")).hasThresholds());
  EXPECT_EQ(readLabels(settings("labels: {min_visibility: 0.25}")).min_visibility, 0.25);
}

TEST(ReadLabels, RefusesWhatIsOutOfRange) {
  Parameters root = settings("labels: {min_visibility: 25, min_pixels: -1, keypoint_tolerance: 0}");
  (void)readLabels(root);
  EXPECT_THAT(root.errors(), ElementsAre(HasSubstr("labels/min_visibility: found 25"),
                                         HasSubstr("labels/min_pixels: found -1"),
                                         HasSubstr("labels/keypoint_tolerance")));
}

TEST(ReadClasses, NumberNamesInAlphabeticalOrder) {
  std::vector<scene::ObjectOptions> objects = {objectOf("a", "rover"), objectOf("b", "drone"),
                                               objectOf("c", "rover")};
  EXPECT_EQ(classesOf(settings("{}"), objects), "0 drone, 1 rover");
  EXPECT_EQ(objects[0].class_id, 1);
  EXPECT_EQ(objects[1].class_id, 0);
  EXPECT_EQ(objects[2].class_id, 1);
}

TEST(ReadClasses, KeepNumbersAndNumberNamesRoundThem) {
  std::vector<scene::ObjectOptions> objects = {objectOf("a", "0"), objectOf("b", "7"),
                                               objectOf("c", "drone"), objectOf("d", "cat")};
  EXPECT_EQ(classesOf(settings("{}"), objects), "0 0, 1 cat, 2 drone, 7 7");
  EXPECT_EQ(objects[1].class_id, 7);
}

TEST(ReadClasses, TextsThatOnlyLookLikeNumbersAreNames) {
  std::vector<scene::ObjectOptions> objects = {objectOf("a", "007"), objectOf("b", "-1")};
  EXPECT_EQ(classesOf(settings("{}"), objects), "0 -1, 1 007");
}

TEST(ReadClasses, AListNumbersThemFromZero) {
  std::vector<scene::ObjectOptions> objects = {objectOf("a", "rover")};
  EXPECT_EQ(classesOf(settings("classes: [person, rover]"), objects), "0 person, 1 rover");
  EXPECT_EQ(objects[0].class_id, 1);
}

TEST(ReadClasses, AMapGivesNumbersAndObjectsMayNameEither) {
  std::vector<scene::ObjectOptions> objects = {objectOf("a", "rover"), objectOf("b", "26")};
  EXPECT_EQ(classesOf(settings("classes: {rover: 3, car: 26}"), objects), "3 rover, 26 car");
  EXPECT_EQ(objects[0].class_id, 3);
  EXPECT_EQ(objects[1].class_id, 26);
  EXPECT_EQ(objects[1].class_name, "car");
  EXPECT_EQ(objects[1].class_text, "26");
}

TEST(ReadClasses, RefuseAnObjectOfNoClass) {
  std::vector<scene::ObjectOptions> objects = {objectOf("a", "rovr")};
  Parameters root = settings("classes: [person, rover]");
  (void)readClasses(root, objects);
  EXPECT_THAT(root.errors(),
              ElementsAre(AllOf(HasSubstr("a/class: found 'rovr', which is not among the classes"),
                                HasSubstr("rover"))));
}

TEST(ReadClasses, RefuseNumbersTwiceAndOutOfRange) {
  std::vector<scene::ObjectOptions> objects;
  Parameters root = settings("classes: {a: 1, b: 1, c: -2, d: 70000}");
  (void)readClasses(root, objects);
  EXPECT_THAT(root.errors(), ElementsAre(HasSubstr("its number 1 more than once"),
                                         HasSubstr("found the number -2 of 'c'"),
                                         HasSubstr("found the number 70000 of 'd'")));
}

TEST(ReadWorldClasses, ReadsNamesAndLabels) {
  const scene::WorldClasses classes =
      readWorldClasses(settings("world_classes: {floor: ground_plane, plant: [3, 'tree_*']}"), {});
  EXPECT_THAT(classes, ElementsAre(Pair("floor", ElementsAre("ground_plane")),
                                   Pair("plant", ElementsAre("3", "tree_*"))));
  EXPECT_THAT(readWorldClasses(settings("{}"), {}), IsEmpty());
}

TEST(ReadWorldClasses, RefusesNamesOfObjectsAndWhatIsNoName) {
  Parameters taken = settings("world_classes: {rover: [ground_plane], wall: [1.5]}");
  (void)readWorldClasses(taken, {{0, "rover"}});
  EXPECT_THAT(taken.errors(),
              ElementsAre(HasSubstr("world_classes/rover: found a name that is also"),
                          HasSubstr("world_classes/wall: found [1.5]; it should be "
                                    "a list of names")));
}

TEST(ReadSplit, ReadsAGapBetweenBlocksAlone) {
  EXPECT_EQ(readSplit(settings("split: {train: 1, gap: 2.5}")).gap, 2.5);
  Parameters negative = settings("split: {train: 1, gap: -1}");
  (void)readSplit(negative);
  EXPECT_THAT(negative.errors(), ElementsAre(HasSubstr("split/gap: found -1.0; it should be")));
  Parameters drawn = settings("split: {train: 1, gap: 1, by: scenes}");
  (void)readSplit(drawn);
  EXPECT_THAT(drawn.errors(), ElementsAre(HasSubstr("only blocks have gaps")));
}

TEST(ReadSplit, IsNoneUnlessItIsSet) { EXPECT_THAT(readSplit(settings("{}")).shares, IsEmpty()); }

TEST(ReadSplit, HasTheSharesAboveZero) {
  const SplitConfig split = readSplit(settings("split: {train: 0.9, val: 0.1, test: 0}"));
  EXPECT_THAT(split.shares, ElementsAre(Pair("train", 0.9), Pair("val", 0.1)));
  EXPECT_EQ(split.by, SplitBy::kBlocks);
  EXPECT_EQ(readSplit(settings("split: {train: 1, by: scenes}")).by, SplitBy::kScenes);
  EXPECT_EQ(readSplit(settings("split: {train: 1, by: balanced_blocks}")).by,
            SplitBy::kBalancedBlocks);
}

TEST(ReadSplit, RefusesWhatDoesNotAddUp) {
  Parameters sum = settings("split: {train: 0.8, val: 0.1}");
  (void)readSplit(sum);
  EXPECT_THAT(sum.errors(), ElementsAre(HasSubstr("split: found shares that add up to 0.9")));
  Parameters rounded = settings("split: {train: 0.7, val: 0.1, test: 0.1}");
  (void)readSplit(rounded);
  EXPECT_THAT(rounded.errors(), ElementsAre(HasSubstr("add up to 0.9;")));
  Parameters share = settings("split: {train: 80, val: 20}");
  (void)readSplit(share);
  EXPECT_THAT(share.errors(),
              ElementsAre(HasSubstr("split/train: found 80"), HasSubstr("split/val: found 20")));
  Parameters by = settings("split: {train: 1, by: moon}");
  (void)readSplit(by);
  EXPECT_THAT(by.errors(), ElementsAre(HasSubstr("split/by: found 'moon'")));
}

}  // namespace label_config_test
}  // namespace synthetic_dataset::config
