#include <set>

#include <opencv2/imgcodecs.hpp>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "plugins/plugin_harness.h"
#include "plugins/written_files.h"

namespace synthetic_dataset {
namespace coco_writer_test {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

/// Unpacks COCO's compressed counts, written from the format's description: letters from '0' on
/// hold five bits and, in the sixth, whether the number continues; the highest bit of a number's
/// last letter is its sign.
std::vector<std::int64_t> unpacked(const std::string& counts) {
  std::vector<std::int64_t> runs;
  std::int64_t number = 0;
  std::int64_t weight = 1;
  for (const char letter : counts) {
    const int value = letter - '0';
    number += weight * (value % 32);
    weight *= 32;
    if (value >= 32) continue;
    if (value >= 16) number -= weight;
    if (runs.size() > 2) number += runs[runs.size() - 2];
    runs.push_back(number);
    number = 0;
    weight = 1;
  }
  return runs;
}

cv::Mat1b maskOf(const json& segmentation) {
  cv::Mat1b mask(segmentation["size"][0].get<int>(), segmentation["size"][1].get<int>(),
                 std::uint8_t{0});
  int place = 0;
  bool on = false;
  for (const std::int64_t run : unpacked(segmentation["counts"].get<std::string>())) {
    for (std::int64_t i = 0; i < run; ++i, ++place) {
      mask(place % mask.rows, place / mask.rows) = on ? 255 : 0;
    }
    on = !on;
  }
  EXPECT_EQ(place, mask.rows * mask.cols);
  return mask;
}

class Coco : public PluginTest {
 protected:
  Coco() : PluginTest("synthetic_dataset/Coco") {
    addObject("a", 0);
    addObject("b", 2);
    dataset_.classes = {{0, "cup"}, {2, "fork \"lift\""}};
  }

  void addObject(const std::string& name, int class_id) {
    ObjectInfo info;
    info.name = name;
    info.class_id = class_id;
    dataset_.objects.push_back(info);
  }

  void giveKeypoints(std::size_t object, const std::vector<std::string>& names) {
    dataset_.objects[object].keypoint_names = names;
    dataset_.objects[object].keypoint_count = names.size();
  }

  /// A scene with the dataset's first objects at these pixels.
  [[nodiscard]] Scene sceneOf(std::int64_t index, const std::vector<cv::Rect>& pixels) const {
    std::vector<SceneObject> objects;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      objects.push_back(seen(dataset_.objects[i].name, pixels[i]));
      objects.back().class_id = dataset_.objects[i].class_id;
    }
    return scene(index, objects);
  }

  [[nodiscard]] json written(const std::string& name) const {
    return json::parse(test::contentOf(folder() + "annotations/" + name + ".json"));
  }

  /// The annotations of a dataset of these scenes.
  [[nodiscard]] json annotationsOf(const std::vector<Scene>& scenes) const {
    runAll(scenes);
    return written("instances_train")["annotations"];
  }
};

TEST_F(Coco, WritesEachImageOnceUnderItsName) {
  load({});
  EXPECT_THAT(filesOf(sceneOf(3, {{10, 20, 30, 40}, {100, 100, 5, 5}})),
              ElementsAre(Pair("images/00000003.png", "<image>")));
}

TEST_F(Coco, PutsImagesOfASplitIntoItsFolder) {
  dataset_.splits = {{"train", 1}, {"val", 1}};
  load({{"image_format", "jpg"}});
  Scene scene = sceneOf(3, {});
  scene.split = "val";
  scene.name = "front/00000003";
  EXPECT_THAT(filesOf(scene), ElementsAre(Pair("images/val/front/00000003.jpg", "<image>")));
}

TEST_F(Coco, ListsImages) {
  load({});
  runAll({sceneOf(0, {}), sceneOf(7, {})});
  const json images = written("instances_train")["images"];
  ASSERT_EQ(images.size(), 2U);
  EXPECT_EQ(images[1]["id"], 8);
  EXPECT_EQ(images[1]["file_name"], "00000007.png");
  EXPECT_EQ(images[1]["width"], 640);
  EXPECT_EQ(images[1]["height"], 480);
  EXPECT_EQ(images[1]["synthetic_dataset"]["stamp_ns"], 7);
}

TEST_F(Coco, ListsAllClassesFromOneOn) {
  load({});
  runAll({});
  const json categories = written("instances_train")["categories"];
  ASSERT_EQ(categories.size(), 2U);
  EXPECT_EQ(categories[0], json({{"id", 1}, {"name", "cup"}, {"supercategory", "object"}}));
  EXPECT_EQ(categories[1],
            json({{"id", 3}, {"name", "fork \"lift\""}, {"supercategory", "object"}}));
}

TEST_F(Coco, HasTheListsOfTheFormatWithoutAnyScene) {
  load({});
  runAll({});
  const json file = written("instances_train");
  EXPECT_EQ(file["images"], json::array());
  EXPECT_EQ(file["annotations"], json::array());
  EXPECT_EQ(file["licenses"], json::array());
  EXPECT_TRUE(file["info"].is_object());
}

TEST_F(Coco, ListsTheLicencesOfWhatScenesAreMadeOf) {
  dataset_.credits = {{"Ada", "MIT", {"m/model.sdf", "m/skin.png"}},
                      {"", "LICENSE", {"w/w.world"}}};
  load({});
  runAll({});
  const json licenses = written("instances_train")["licenses"];
  ASSERT_EQ(licenses.size(), 2U);
  EXPECT_EQ(licenses[0]["id"], 1);
  EXPECT_EQ(licenses[0]["name"], "MIT");
  EXPECT_EQ(licenses[0]["synthetic_dataset"],
            json({{"author", "Ada"}, {"files", {"m/model.sdf", "m/skin.png"}}}));
  EXPECT_EQ(licenses[1]["name"], "LICENSE");
}

TEST_F(Coco, MeasuresABoxFromTheImagesEdge) {
  load({});
  const json annotations = annotationsOf({sceneOf(0, {{10, 20, 30, 40}})});
  EXPECT_EQ(annotations[0]["bbox"], json({10.0, 20.0, 30.0, 40.0}));
  EXPECT_EQ(annotations[0]["area"], 1200);
  EXPECT_EQ(annotations[0]["iscrowd"], 0);
}

TEST_F(Coco, NeverWritesIgnore) {
  load({});
  EXPECT_FALSE(annotationsOf({sceneOf(0, {{10, 20, 30, 40}})})[0].contains("ignore"));
}

TEST_F(Coco, NumbersAnnotationsBySceneAndObjectAlone) {
  load({});
  const json annotations =
      annotationsOf({sceneOf(2, {{0, 0, 9, 9}, {50, 0, 9, 9}}), sceneOf(4, {{0, 0, 9, 9}})});
  ASSERT_EQ(annotations.size(), 3U);
  EXPECT_EQ(annotations[0]["id"], 2 * 2 + 1);
  EXPECT_EQ(annotations[1]["id"], 2 * 2 + 2);
  EXPECT_EQ(annotations[2]["id"], 4 * 2 + 1);
  EXPECT_EQ(annotations[2]["image_id"], 5);
  EXPECT_EQ(annotations[1]["category_id"], 3);
}

TEST_F(Coco, LeavesOutWhatHasNoVisiblePixelOrIsDropped) {
  load({});
  Scene scene = sceneOf(0, {{10, 20, 30, 40}, {700, 20, 30, 40}});
  scene.objects[0].dropped = true;
  EXPECT_THAT(annotationsOf({scene}), IsEmpty());
}

TEST_F(Coco, KeepsBoxesAtEachOfTheImagesEdges) {
  addObject("c", 0);
  addObject("d", 0);
  load({});
  const json annotations = annotationsOf(
      {sceneOf(0, {{-5, 100, 10, 10}, {635, 100, 10, 10}, {100, -5, 10, 10}, {100, 475, 10, 10}})});
  EXPECT_EQ(annotations[0]["bbox"], json({0.0, 100.0, 5.0, 10.0}));
  EXPECT_EQ(annotations[1]["bbox"], json({635.0, 100.0, 5.0, 10.0}));
  EXPECT_EQ(annotations[2]["bbox"], json({100.0, 0.0, 10.0, 5.0}));
  EXPECT_EQ(annotations[3]["bbox"], json({100.0, 475.0, 10.0, 5.0}));
  EXPECT_EQ(annotations[0]["synthetic_dataset"]["amodal_bbox"], json({-5.0, 100.0, 10.0, 10.0}));
  EXPECT_EQ(annotations[0]["synthetic_dataset"]["truncation"], 0.5);
}

TEST_F(Coco, CutsTheLooseBoxToTheImage) {
  load({{"box", "loose"}});
  Scene scene = sceneOf(0, {{10, 20, 30, 40}});
  scene.objects[0].loose_box = Box{-7.25, 18.5, 45.0, 70.0};
  // From -0.5 and 18.5 on, half a pixel more in COCO's coordinates.
  EXPECT_EQ(annotationsOf({scene})[0]["bbox"], json({0.0, 19.0, 45.5, 51.5}));
}

TEST_F(Coco, PacksMasksThatDecodeToThemselves) {
  load({});
  Scene scene = sceneOf(0, {{10, 20, 30, 40}, {635, 470, 20, 20}});
  const Mask holed = painted(scene.objects[0].visible_mask(), {15, 25, 10, 10}, false);
  scene.objects[0].visible_mask = painted(holed, {200, 300, 1, 1}, true);  // a second part
  const json annotations = annotationsOf({scene});
  for (std::size_t i = 0; i < 2; ++i) {
    const cv::Mat1b decoded = maskOf(annotations[i]["segmentation"]);
    EXPECT_EQ(cv::countNonZero(decoded != scene.objects[i].visible_mask().whole()), 0);
    EXPECT_EQ(annotations[i]["area"], scene.objects[i].visible_mask().count());
  }
}

TEST_F(Coco, DrawsPolygonsAlongThePixelsEdges) {
  load({{"segmentation", "polygons"}});
  Scene scene = sceneOf(0, {{10, 20, 30, 40}});
  scene.objects[0].visible_mask = painted(scene.objects[0].visible_mask(), {200, 300, 1, 1}, true);
  EXPECT_EQ(annotationsOf({scene})[0]["segmentation"],
            json({{10, 20, 40, 20, 40, 60, 10, 60}, {200, 300, 201, 300, 201, 301, 200, 301}}));
}

TEST_F(Coco, FlagsKeypoints) {
  giveKeypoints(0, {"tip", "heel", "far", "behind"});
  dataset_.objects[0].skeleton = {{0, 1}, {1, 3}};
  load({});
  Scene scene = sceneOf(0, {{10, 20, 30, 40}});
  scene.objects[0].keypoints = {
      keypoint(Eigen::Vector2d(12.5, 30.0), 1.0, KeypointState::kVisible),
      keypoint(Eigen::Vector2d(20.0, 31.0), 1.0, KeypointState::kHiddenByItself),
      keypoint(Eigen::Vector2d(-3.0, 31.0), 1.0, KeypointState::kOutside),
      keypoint(std::nullopt, -1.0, KeypointState::kOutside)};
  const json annotation = annotationsOf({scene})[0];
  EXPECT_EQ(annotation["keypoints"],
            json({12.5, 30.0, 2, 20.0, 31.0, 1, 0.0, 0.0, 0, 0.0, 0.0, 0}));
  EXPECT_EQ(annotation["num_keypoints"], 2);
  const json category = written("instances_train")["categories"][0];
  EXPECT_EQ(category["keypoints"], json({"tip", "heel", "far", "behind"}));
  EXPECT_EQ(category["skeleton"], json({{1, 2}, {2, 4}}));
}

TEST_F(Coco, OrdersKeypointsOfAClassByTheirNames) {
  addObject("c", 0);
  giveKeypoints(0, {"tip", "heel"});
  giveKeypoints(2, {"heel", "toe"});
  load({});
  Scene scene = sceneOf(0, {{10, 20, 30, 40}, {100, 20, 9, 9}, {200, 20, 30, 40}});
  scene.objects[0].keypoints = {
      keypoint(Eigen::Vector2d(11.0, 21.0), 1.0, KeypointState::kVisible),
      keypoint(Eigen::Vector2d(12.0, 22.0), 1.0, KeypointState::kVisible)};
  scene.objects[2].keypoints = {
      keypoint(Eigen::Vector2d(201.0, 21.0), 1.0, KeypointState::kVisible),
      keypoint(Eigen::Vector2d(202.0, 22.0), 1.0, KeypointState::kHiddenByAnother)};
  const json annotations = annotationsOf({scene});
  EXPECT_EQ(written("instances_train")["categories"][0]["keypoints"], json({"tip", "heel", "toe"}));
  EXPECT_EQ(annotations[0]["keypoints"], json({11.0, 21.0, 2, 12.0, 22.0, 2, 0.0, 0.0, 0}));
  EXPECT_EQ(annotations[1]["keypoints"], json::array());  // its class has none
  EXPECT_EQ(annotations[1]["num_keypoints"], 0);
  EXPECT_EQ(annotations[2]["keypoints"], json({0.0, 0.0, 0, 201.0, 21.0, 2, 202.0, 22.0, 1}));
}

TEST_F(Coco, LeavesOutKeypointsWhenTold) {
  giveKeypoints(0, {"tip"});
  load({{"keypoints", false}});
  EXPECT_FALSE(annotationsOf({sceneOf(0, {{10, 20, 30, 40}})})[0].contains("keypoints"));
  EXPECT_FALSE(written("instances_train")["categories"][0].contains("keypoints"));
}

TEST_F(Coco, WritesAFileForEachSplit) {
  dataset_.splits = {{"train", 1}, {"val", 1}, {"test", 0}};
  load({});
  Scene first = sceneOf(0, {{10, 20, 30, 40}});
  first.split = "val";
  Scene second = sceneOf(1, {{10, 20, 30, 40}});
  second.split = "train";
  runAll({first, second});
  EXPECT_EQ(written("instances_val")["images"][0]["id"], 1);
  EXPECT_EQ(written("instances_train")["images"][0]["id"], 2);
  EXPECT_EQ(written("instances_train")["annotations"].size(), 1U);
  EXPECT_THAT(written("instances_test")["images"], IsEmpty());
}

TEST_F(Coco, NumbersPanopticSegmentsByObject) {
  for (int i = 0; i < 298; ++i) addObject("x" + std::to_string(i), 0);
  load({{"panoptic", true}});
  std::vector<cv::Rect> pixels;  // 300 objects of 3 x 2 pixels that touch in rows
  for (int i = 0; i < 300; ++i) pixels.emplace_back(i % 100 * 3, 100 + i / 100 * 2, 3, 2);
  runAll({sceneOf(0, pixels)});
  const json file = written("panoptic_train");
  const json& annotation = file["annotations"][0];
  EXPECT_EQ(annotation["image_id"], 1);
  EXPECT_EQ(annotation["file_name"], "00000000.png");
  ASSERT_EQ(annotation["segments_info"].size(), 300U);
  EXPECT_EQ(annotation["segments_info"][299], json({{"id", 300},
                                                    {"category_id", 1},
                                                    {"area", 6},
                                                    {"bbox", {297.0, 104.0, 3.0, 2.0}},
                                                    {"iscrowd", 0}}));

  const cv::Mat ids = cv::imread(folder() + "annotations/panoptic_train/00000000.png");
  // Object 300 = 44 + 256 * 1: red 44, green 1, blue 0; OpenCV turns the order round.
  EXPECT_EQ(ids.at<cv::Vec3b>(105, 299), cv::Vec3b(0, 1, 44));
  EXPECT_EQ(ids.at<cv::Vec3b>(0, 0), cv::Vec3b(0, 0, 0));
  std::set<int> in_picture;
  for (const cv::Vec3b& pixel : cv::Mat_<cv::Vec3b>(ids)) {
    in_picture.insert(pixel[2] + 256 * pixel[1] + 65536 * pixel[0]);
  }
  EXPECT_EQ(in_picture.size(), 301U);
}

TEST_F(Coco, LeavesPanopticPixelsOfDroppedObjectsVoid) {
  load({{"panoptic", true}});
  Scene scene = sceneOf(0, {{10, 20, 30, 40}, {100, 20, 30, 40}});
  scene.objects[0].dropped = true;
  runAll({scene});
  const cv::Mat ids = cv::imread(folder() + "annotations/panoptic_train/00000000.png");
  EXPECT_EQ(ids.at<cv::Vec3b>(30, 20), cv::Vec3b(0, 0, 0));
  EXPECT_EQ(ids.at<cv::Vec3b>(30, 110), cv::Vec3b(0, 0, 2));
  EXPECT_EQ(written("panoptic_train")["annotations"][0]["segments_info"].size(), 1U);
}

TEST_F(Coco, GivesPanopticClassesColoursOfTheirOwn) {
  load({{"panoptic", true}});
  runAll({});
  const json categories = written("panoptic_train")["categories"];
  EXPECT_EQ(categories[0]["isthing"], 1);
  EXPECT_EQ(categories[0]["color"], json({128, 0, 0}));
  EXPECT_EQ(categories[1]["color"], json({0, 128, 0}));
}

TEST_F(Coco, GivesTheWorldAStuffCategoryWhenAskedTo) {
  load({{"panoptic", true}, {"background", "world"}});
  Scene scene = sceneOf(0, {{10, 20, 30, 40}, {100, 20, 30, 40}});
  scene.objects[0].dropped = true;  // which stays void
  runAll({scene});
  const json file = written("panoptic_train");
  // panopticapi and detectron2 average over the things and over the stuff.
  EXPECT_EQ(file["categories"][1]["isthing"], 1);
  EXPECT_EQ(file["categories"][2]["isthing"], 0);
  EXPECT_EQ(file["categories"][2]["name"], "world");
  EXPECT_EQ(file["categories"][2]["id"], 4);  // the classes are 1 and 3
  EXPECT_EQ(file["annotations"][0]["segments_info"][1], json({{"id", 3},
                                                              {"category_id", 4},
                                                              {"area", 640 * 480 - 2 * 30 * 40},
                                                              {"bbox", {0, 0, 640, 480}},
                                                              {"iscrowd", 0}}));
  const cv::Mat ids = cv::imread(folder() + "annotations/panoptic_train/00000000.png");
  EXPECT_EQ(ids.at<cv::Vec3b>(0, 0), cv::Vec3b(0, 0, 3));
  EXPECT_EQ(ids.at<cv::Vec3b>(30, 20), cv::Vec3b(0, 0, 0));
  EXPECT_EQ(ids.at<cv::Vec3b>(30, 110), cv::Vec3b(0, 0, 2));
  EXPECT_EQ(written("instances_train")["categories"].size(), 2U);
}

TEST_F(Coco, GivesClassesOfTheWorldCategoriesOfStuff) {
  dataset_.world_classes = {"floor", "wall"};
  EXPECT_FALSE(load({}).requirements().world_map);
  EXPECT_TRUE(load({{"panoptic", true}, {"background", "rest"}}).requirements().world_map);
  Scene scene = sceneOf(0, {{10, 20, 30, 40}, {100, 20, 30, 40}});
  cv::Mat world = cv::Mat::zeros(480, 640, CV_16UC1);
  world(cv::Rect(0, 400, 640, 80)) = 1;
  scene.world_map = world;  // no wall is seen
  runAll({scene});
  const json file = written("panoptic_train");
  ASSERT_EQ(file["categories"].size(), 5U);
  EXPECT_EQ(file["categories"][2]["name"], "floor");
  EXPECT_EQ(file["categories"][2]["id"], 4);
  EXPECT_EQ(file["categories"][2]["isthing"], 0);
  EXPECT_EQ(file["categories"][4]["name"], "rest");
  const json& segments = file["annotations"][0]["segments_info"];
  ASSERT_EQ(segments.size(), 4U);
  EXPECT_EQ(segments[2], json({{"id", 3},
                               {"category_id", 4},
                               {"area", 640 * 80},
                               {"bbox", {0, 400, 640, 80}},
                               {"iscrowd", 0}}));
  EXPECT_EQ(segments[3]["id"], 5);
  EXPECT_EQ(segments[3]["category_id"], 6);
  EXPECT_EQ(segments[3]["area"], 640 * 400 - 2 * 30 * 40);
  const cv::Mat ids = cv::imread(folder() + "annotations/panoptic_train/00000000.png");
  EXPECT_EQ(ids.at<cv::Vec3b>(470, 5), cv::Vec3b(0, 0, 3));
  EXPECT_EQ(ids.at<cv::Vec3b>(5, 5), cv::Vec3b(0, 0, 5));
}

TEST_F(Coco, HasPartsBelowTheirObject) {
  dataset_.objects[1].part_names = {"fork", "mast"};
  EXPECT_TRUE(load({}).requirements().part_map);
  Scene scene = sceneOf(0, {{10, 20, 30, 40}, {100, 20, 30, 40}});
  cv::Mat parts = cv::Mat::zeros(480, 640, CV_16UC1);
  parts(cv::Rect(90, 50, 20, 100)) = 2;  // only 10 x 10 of its pixels are the object's
  scene.part_map = parts;
  runAll({scene});
  const json annotations = written("instances_train")["annotations"];
  EXPECT_EQ(annotations[0]["synthetic_dataset"].count("parts"), 0U);
  const json& of_second = annotations[1]["synthetic_dataset"]["parts"];
  ASSERT_EQ(of_second.size(), 1U);
  EXPECT_EQ(of_second[0]["name"], "mast");
  EXPECT_EQ(of_second[0]["bbox"], json({100.0, 50.0, 10.0, 10.0}));
  EXPECT_EQ(of_second[0]["area"], 100);
}

TEST_F(Coco, RefusesABackgroundThatIsAClass) {
  load({{"background", "cup"}});
  EXPECT_THAT(parameters_.errors(), ElementsAre(HasSubstr("w/background: found 'cup'")));
}

/// As for detectron2's Keypoints, where all lists of an image make one array.
TEST_F(Coco, GivesAllAnnotationsAsManyKeypointsWhenAskedTo) {
  giveKeypoints(0, {"tip", "heel"});
  giveKeypoints(1, {"fork"});
  load({{"pad_keypoints", true}});
  Scene scene = sceneOf(0, {{10, 20, 30, 40}, {100, 20, 30, 40}});
  scene.objects[0].keypoints = {
      keypoint(Eigen::Vector2d(11.0, 21.0), 1.0, KeypointState::kVisible),
      keypoint(Eigen::Vector2d(12.0, 22.0), 1.0, KeypointState::kVisible)};
  scene.objects[1].keypoints = {
      keypoint(Eigen::Vector2d(101.0, 21.0), 1.0, KeypointState::kVisible)};
  runAll({scene});
  const json file = written("instances_train");
  EXPECT_EQ(file["annotations"][0]["keypoints"], json({11.0, 21.0, 2, 12.0, 22.0, 2}));
  EXPECT_EQ(file["annotations"][1]["keypoints"], json({101.0, 21.0, 2, 0.0, 0.0, 0}));
  EXPECT_EQ(file["annotations"][1]["num_keypoints"], 1);
  EXPECT_EQ(file["categories"][1]["keypoints"], json({"fork", "unused_1"}));
}

TEST_F(Coco, GivesKeypointsToSomeClassesAlone) {
  giveKeypoints(0, {"tip", "heel"});
  giveKeypoints(1, {"fork"});
  load({{"keypoint_classes", Value::List{"cup"}}, {"annotation_file", "person_keypoints"}});
  Scene scene = sceneOf(0, {{10, 20, 30, 40}, {100, 20, 30, 40}});
  scene.objects[0].keypoints = {
      keypoint(Eigen::Vector2d(11.0, 21.0), 1.0, KeypointState::kVisible),
      keypoint(Eigen::Vector2d(12.0, 22.0), 1.0, KeypointState::kVisible)};
  scene.objects[1].keypoints = {
      keypoint(Eigen::Vector2d(101.0, 21.0), 1.0, KeypointState::kVisible)};
  runAll({scene});
  const json file = written("person_keypoints_train");
  EXPECT_EQ(file["annotations"][0]["num_keypoints"], 2);
  EXPECT_EQ(file["annotations"][1]["keypoints"], json::array());
  EXPECT_EQ(file["categories"][1].count("keypoints"), 0U);
}

TEST_F(Coco, RefusesClassesAndNamesThatItCannotUse) {
  load({{"keypoint_classes", Value::List{"cap"}}, {"annotation_file", "panoptic"}});
  EXPECT_THAT(parameters_.errors(),
              ElementsAre(HasSubstr("w/annotation_file: found 'panoptic'"),
                          HasSubstr("w/keypoint_classes: found 'cap', and no object has this "
                                    "class; did you mean 'cup'?")));
}

TEST_F(Coco, ReplacesBytesThatAreNotUtf8) {
  dataset_.classes[0].name = "caf\xe9 \xe2\x98\x95";
  load({});
  runAll({});
  EXPECT_EQ(written("instances_train")["categories"][0]["name"], "caf\xef\xbf\xbd \xe2\x98\x95");
}

TEST_F(Coco, RefusesAWordThatIsNoSegmentation) {
  load({{"segmentation", "polygon"}});
  EXPECT_THAT(
      parameters_.errors(),
      ElementsAre(HasSubstr("w/segmentation: found 'polygon'; it should be rle or polygons")));
}

TEST_F(Coco, NeedsKeypointStatesWhereThereAreKeypoints) {
  EXPECT_FALSE(load({}).requirements().keypoint_states);
  giveKeypoints(1, {"tip"});
  EXPECT_TRUE(load({}).requirements().keypoint_states);
  EXPECT_TRUE(load({}).requirements().visible_masks);
}

TEST_F(Coco, GivesCategoriesTheIdsThatAreWanted) {
  load({{"category_ids", Value::Map{{"cup", Value(std::int64_t{47})}}},
        {"panoptic", true},
        {"background", "world"}});
  EXPECT_THAT(parameters_.errors(), IsEmpty());
  runAll({sceneOf(0, {{10, 20, 30, 40}, {100, 20, 30, 40}})});
  const json file = written("instances_train");
  EXPECT_EQ(file["annotations"][0]["category_id"], 47);
  EXPECT_EQ(file["annotations"][1]["category_id"], 3);
  EXPECT_EQ(file["categories"][0]["id"], 47);
  EXPECT_EQ(written("panoptic_train")["annotations"][0]["segments_info"][0]["category_id"], 47);
}

TEST_F(Coco, RefusesIdsOfTwoCategoriesAndOfNone) {
  load({{"category_ids",
         Value::Map{{"cup", Value(std::int64_t{3})}, {"cap", Value(std::int64_t{9})}}}});
  EXPECT_THAT(parameters_.errors(),
              ElementsAre(HasSubstr("w/category_ids: found 3 for 'fork \"lift\"', which is also "
                                    "that of 'cup'"),
                          HasSubstr("found 'cap', which is no category; did you mean 'cup'?")));
}

}  // namespace coco_writer_test
}  // namespace synthetic_dataset
