#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "plugins/plugin_harness.h"

namespace synthetic_dataset {
namespace pascal_voc_writer_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Key;
using testing::Not;

class PascalVoc : public PluginTest {
 protected:
  PascalVoc() : PluginTest("synthetic_dataset/PascalVoc") {
    dataset_.classes = {{3, "robot"}, {7, "fork lift"}};
  }

  [[nodiscard]] static SceneObject robot(const cv::Rect& pixels) {
    SceneObject result = seen("a", pixels);
    result.class_id = 3;
    result.class_name = "robot";
    return result;
  }

  [[nodiscard]] static SceneObject lift(const cv::Rect& pixels) {
    SceneObject result = seen("b", pixels);
    result.class_id = 7;
    result.class_name = "fork lift";
    return result;
  }

  [[nodiscard]] std::string annotationOf(std::vector<SceneObject> objects) const {
    return filesOf(scene(0, std::move(objects))).at("Annotations/00000000.xml");
  }

  [[nodiscard]] static std::string box(int left, int top, int right, int bottom) {
    return "<xmin>" + std::to_string(left) + "</xmin>\n\t\t\t<ymin>" + std::to_string(top) +
           "</ymin>\n\t\t\t<xmax>" + std::to_string(right) + "</xmax>\n\t\t\t<ymax>" +
           std::to_string(bottom) + "</ymax>";
  }

  [[nodiscard]] static Scene sceneOf(std::int64_t index, const std::string& split,
                                     std::vector<SceneObject> objects) {
    Scene result = scene(index, std::move(objects));
    result.split = split;
    return result;
  }
};

TEST_F(PascalVoc, WritesAnObjectsElements) {
  load({});
  // Pixels 128 to 191 and 72 to 167, counted from 1.
  EXPECT_EQ(annotationOf({lift({128, 72, 64, 96})}), R"(<annotation>
	<folder>JPEGImages</folder>
	<filename>00000000.jpg</filename>
	<source>
		<database>synthetic_dataset</database>
		<annotation>pixels are counted from 1</annotation>
		<image>synthetic_dataset</image>
	</source>
	<size>
		<width>640</width>
		<height>480</height>
		<depth>3</depth>
	</size>
	<segmented>1</segmented>
	<object>
		<name>fork lift</name>
		<pose>Unspecified</pose>
		<truncated>0</truncated>
		<occluded>0</occluded>
		<difficult>0</difficult>
		<bndbox>
			<xmin>129</xmin>
			<ymin>73</ymin>
			<xmax>192</xmax>
			<ymax>168</ymax>
		</bndbox>
	</object>
</annotation>
)");
}

TEST_F(PascalVoc, CountsPixelsFromZeroWhenAskedTo) {
  load({{"coordinates", "zero_based"}});
  const std::string text = annotationOf({robot({128, 72, 64, 96})});
  EXPECT_THAT(text, HasSubstr(box(128, 72, 191, 167)));
  EXPECT_THAT(text, HasSubstr("pixels are counted from 0"));
}

TEST_F(PascalVoc, KeepsBoxesInTheImage) {
  load({});
  EXPECT_THAT(annotationOf({robot({0, 0, 640, 480})}), HasSubstr(box(1, 1, 640, 480)));
  EXPECT_THAT(annotationOf({robot({-5, -5, 6, 6})}), HasSubstr(box(1, 1, 1, 1)));
  EXPECT_THAT(annotationOf({robot({639, 479, 9, 9})}), HasSubstr(box(640, 480, 640, 480)));
}

TEST_F(PascalVoc, TakesAllPixelsThatALooseBoxTouches) {
  load({{"box", "loose"}});
  SceneObject object = robot({10, 10, 5, 5});
  // From the middle of pixel 9 to the first quarter of pixel 16.
  object.loose_box = Box{9.0, 9.0, 15.75, 15.75};
  EXPECT_THAT(annotationOf({object}), HasSubstr(box(10, 10, 17, 17)));
}

TEST_F(PascalVoc, SaysWhatIsTruncatedOccludedAndDifficult) {
  load({});
  SceneObject object = robot({10, 10, 10, 10});
  object.pixels = counts(200, 188, 180);  // 6 % are cut off, 8 of 188 are hidden: 4 %
  EXPECT_THAT(annotationOf({object}),
              HasSubstr("<truncated>1</truncated>\n\t\t<occluded>0</occluded>\n\t\t"
                        "<difficult>0</difficult>"));
  object.pixels = counts(200, 192, 38);  // 4 % are cut off, 19 % visible
  EXPECT_THAT(annotationOf({object}),
              HasSubstr("<truncated>0</truncated>\n\t\t<occluded>1</occluded>\n\t\t"
                        "<difficult>1</difficult>"));
}

TEST_F(PascalVoc, EscapesNames) {
  load({});
  SceneObject object = robot({10, 10, 10, 10});
  object.class_name = "a<b> & \"c\"";
  EXPECT_THAT(annotationOf({object}), HasSubstr("<name>a&lt;b&gt; &amp; \"c\"</name>"));
}

TEST_F(PascalVoc, WritesAnImageWithoutObjects) {
  load({});
  SceneObject dropped = robot({10, 10, 10, 10});
  dropped.dropped = true;
  const Scene empty = scene(4, {dropped, robot({900, 0, 5, 5})});
  const auto files = filesOf(empty);
  EXPECT_THAT(files, ElementsAre(Key("Annotations/00000004.xml"), Key("JPEGImages/00000004.jpg"),
                                 Key("SegmentationClass/00000004.png"),
                                 Key("SegmentationObject/00000004.png")));
  EXPECT_THAT(files.at("Annotations/00000004.xml"), Not(HasSubstr("<object>")));
}

TEST_F(PascalVoc, PaintsClassesAndObjects) {
  load({});
  SceneObject dropped = robot({300, 100, 10, 10});
  dropped.dropped = true;
  const Scene all =
      scene(0, {lift({0, 0, 10, 10}), dropped, robot({10, 0, 10, 10}), robot({639, 479, 1, 1})});
  const cv::Mat classes = pictureOf(all, "SegmentationClass/00000000.png");
  const cv::Mat objects = pictureOf(all, "SegmentationObject/00000000.png");
  const auto at = [&](int x, int y) {
    return std::make_pair(static_cast<int>(classes.at<uchar>(y, x)),
                          static_cast<int>(objects.at<uchar>(y, x)));
  };
  EXPECT_EQ(at(9, 9), std::make_pair(2, 1));
  EXPECT_EQ(at(10, 9), std::make_pair(1, 2));
  EXPECT_EQ(at(639, 479), std::make_pair(1, 3));
  EXPECT_EQ(at(20, 0), std::make_pair(0, 0));
  EXPECT_EQ(at(305, 105), std::make_pair(255, 255));
}

TEST_F(PascalVoc, PaintsVoidBordersWhenAskedTo) {
  load({{"void_border", 1}});
  const Scene two = scene(0, {robot({100, 100, 10, 10}), robot({110, 100, 10, 10})});
  const cv::Mat classes = pictureOf(two, "SegmentationClass/00000000.png");
  // A pixel at each side of a border; the border between the two objects too.
  std::vector<int> row;
  for (int x = 98; x < 113; ++x) row.push_back(classes.at<uchar>(105, x));
  EXPECT_THAT(row, ElementsAre(0, 255, 255, 1, 1, 1, 1, 1, 1, 1, 1, 255, 255, 1, 1));
}

TEST_F(PascalVoc, WritesPicturesInVocsColours) {
  load({});
  runAll({scene(0, {robot({0, 0, 10, 10}), lift({20, 0, 10, 10})})});
  const cv::Mat picture = cv::imread(folder() + "SegmentationClass/00000000.png");
  EXPECT_EQ(picture.at<cv::Vec3b>(0, 0), cv::Vec3b(0, 0, 128));
  EXPECT_EQ(picture.at<cv::Vec3b>(0, 20), cv::Vec3b(0, 128, 0));
  EXPECT_EQ(test::readFile(folder() + "labelmap.txt"),
            "# label:color_rgb:parts:actions\nbackground:0,0,0::\nrobot:128,0,0::\n"
            "fork lift:0,128,0::\n");
}

TEST_F(PascalVoc, WarnsOfMoreObjectsThanAPictureCanTellApart) {
  const output::WriterHost& host = load({});
  std::vector<SceneObject> many(300, robot({0, 0, 1, 1}));
  many[253] = robot({10, 0, 1, 1});
  many[254] = robot({20, 0, 1, 1});
  const Scene full = scene(0, many);
  EXPECT_THAT(host.writeScene(full).warnings, ElementsAre(HasSubstr("254 objects")));
  EXPECT_EQ(pictureOf(full, "SegmentationObject/00000000.png").at<uchar>(0, 10), 254);
  EXPECT_EQ(pictureOf(full, "SegmentationObject/00000000.png").at<uchar>(0, 20), 255);
  EXPECT_EQ(pictureOf(full, "SegmentationClass/00000000.png").at<uchar>(0, 20), 1);
}

TEST_F(PascalVoc, RefusesPicturesOfMoreThan254Classes) {
  dataset_.classes.clear();
  for (int i = 0; i < 255; ++i) dataset_.classes.push_back({i, "c" + std::to_string(i)});
  load({});
  EXPECT_THAT(parameters_.errors(),
              ElementsAre(HasSubstr("w/segmentation: found true; it should be false")));
  load({{"segmentation", false}});
  EXPECT_THAT(parameters_.errors(), IsEmpty());
  EXPECT_THAT(filesOf(scene(0, {})),
              ElementsAre(Key("Annotations/00000000.xml"), Key("JPEGImages/00000000.jpg")));
}

TEST_F(PascalVoc, ListsImagesBySplitAndClass) {
  dataset_.splits = {{"train", 2}, {"val", 1}, {"test", 1}};
  load({});
  SceneObject hidden = robot({0, 0, 10, 10});
  hidden.pixels.visible = 10;  // of 100
  runAll({sceneOf(0, "train", {robot({0, 0, 10, 10})}), sceneOf(1, "val", {hidden}),
          sceneOf(2, "train", {lift({0, 0, 10, 10})}), sceneOf(3, "test", {})});
  const auto list = [&](const std::string& name) {
    return test::readFile(folder() + "ImageSets/" + name);
  };
  EXPECT_EQ(list("Main/train.txt"), "00000000\n00000002\n");
  EXPECT_EQ(list("Main/trainval.txt"), "00000000\n00000001\n00000002\n");
  EXPECT_EQ(list("Main/test.txt"), "00000003\n");
  EXPECT_EQ(list("Segmentation/val.txt"), "00000001\n");
  EXPECT_EQ(list("Main/robot_trainval.txt"), "00000000  1\n00000001  0\n00000002 -1\n");
}

TEST_F(PascalVoc, PutsEverythingIntoTrainWithoutSplits) {
  load({});
  runAll({scene(0, {})});
  EXPECT_EQ(test::readFile(folder() + "ImageSets/Main/train.txt"), "00000000\n");
  EXPECT_EQ(test::readFile(folder() + "ImageSets/Main/trainval.txt"), "00000000\n");
}

TEST_F(PascalVoc, NamesFilesOfSeveralCamerasFlat) {
  load({{"image_format", "png"}, {"segmentation", false}});
  Scene front = scene(0, {});
  front.name = "front left/00000000";
  const auto files = filesOf(front);
  ASSERT_EQ(files.size(), 2U);
  EXPECT_THAT(files.rbegin()->first,
              testing::MatchesRegex("JPEGImages/front_left_.*_00000000.png"));
}

TEST_F(PascalVoc, RefusesSharesAndBordersOutOfRange) {
  load({{"truncated_above", 1.5}, {"void_border", -1}});
  EXPECT_THAT(parameters_.errors(),
              ElementsAre(HasSubstr("w/truncated_above: found 1.5; it should be 0 to 1"),
                          HasSubstr("w/void_border: found -1; it should be 0 to 100")));
}

TEST_F(PascalVoc, ShowsClassesOfTheWorldAfterThoseOfObjects) {
  dataset_.world_classes = {"floor", "wall"};
  EXPECT_TRUE(load({}).requirements().world_map);
  Scene one = scene(0, {robot({10, 10, 20, 20})});
  one.objects[0].instance = 1;
  cv::Mat world = cv::Mat::zeros(480, 640, CV_16UC1);
  world(cv::Rect(0, 0, 640, 100)) = 2;
  one.world_map = world;
  const cv::Mat classes = pictureOf(one, "SegmentationClass/00000000.png");
  EXPECT_EQ(classes.at<uchar>(15, 15), 1);
  EXPECT_EQ(classes.at<uchar>(5, 5), 4);
  EXPECT_EQ(classes.at<uchar>(200, 5), 0);
  EXPECT_EQ(pictureOf(one, "SegmentationObject/00000000.png").at<uchar>(5, 5), 0);
  runAll({one});
  EXPECT_THAT(test::readFile(folder() + "labelmap.txt"), HasSubstr("\nfloor:128,128,0::\nwall:"));
}

TEST_F(PascalVoc, HasPartsInTheirObject) {
  ObjectInfo info;
  info.name = "a";
  info.class_id = 3;
  info.part_names = {"fork", "mast"};
  dataset_.objects = {info};
  EXPECT_TRUE(load({}).requirements().part_map);
  Scene one = scene(0, {robot({10, 10, 20, 20})});
  cv::Mat parts = cv::Mat::zeros(480, 640, CV_16UC1);
  parts(cv::Rect(25, 0, 100, 480)) = 2;
  one.part_map = parts;
  // Columns 25 to 29 and rows 10 to 29, counted from 1.
  EXPECT_THAT(filesOf(one).at("Annotations/00000000.xml"),
              HasSubstr("\t\t</bndbox>\n\t\t<part>\n\t\t\t<name>mast</name>\n\t\t\t<bndbox>\n"
                        "\t\t\t\t<xmin>26</xmin>\n\t\t\t\t<ymin>11</ymin>\n"
                        "\t\t\t\t<xmax>30</xmax>\n\t\t\t\t<ymax>30</ymax>\n\t\t\t</bndbox>\n"
                        "\t\t</part>\n\t</object>\n"));
  // Datumaro refuses a part that the class does not have.
  runAll({one});
  EXPECT_THAT(test::readFile(folder() + "labelmap.txt"),
              HasSubstr("\nrobot:128,0,0:fork,mast:\nfork lift:0,128,0::\n"));
}

/// VOCdevkit's VOCevalcls opens `<class>_<list>.txt`.
TEST_F(PascalVoc, NamesListsOfClassesByTheirClass) {
  load({});
  runAll({scene(0, {robot({10, 10, 20, 20})})});
  EXPECT_EQ(test::readFile(folder() + "ImageSets/Main/fork lift_train.txt"), "00000000 -1\n");
  EXPECT_EQ(test::readFile(folder() + "ImageSets/Main/robot_train.txt"), "00000000  1\n");
}

}  // namespace pascal_voc_writer_test
}  // namespace synthetic_dataset
