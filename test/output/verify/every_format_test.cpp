#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include "output/verify/verification_fixture.h"
#include "plugins/format_cases.h"
#include "support/error_messages.h"

namespace synthetic_dataset::output {
namespace every_format_test {

using testing::IsEmpty;
using testing::SizeIs;

/// Expectations for an unmodified dataset of each format.
class VerifyEveryFormat : public VerificationTest, public testing::WithParamInterface<FormatCase> {
 protected:
  VerifyEveryFormat() : VerificationTest(GetParam().type, GetParam().has_lidar) {}
};

TEST_P(VerifyEveryFormat, FindsNothingWrong) {
  write({sceneOfBoth(0), sceneOfBoth(1)}, GetParam().parameters);
  EXPECT_THAT(problems(), IsEmpty());
  EXPECT_THAT(remarks_, SizeIs(GetParam().remarks));
  EXPECT_EQ(counts_.scenes, 2);
  EXPECT_GT(counts_.files, 0);
  EXPECT_EQ(counts_.labels, 2 * GetParam().labels_of_a_scene);
}

TEST_P(VerifyEveryFormat, FindsNothingWrongWithoutObjectsInView) {
  Scene empty = sceneOfBoth(0);
  for (SceneObject& each : empty.objects) {
    const auto instance = each.instance;
    each = object(each.name);
    each.id = each.name;
    each.instance = instance;
    each.keypoints.resize(1);
  }
  cv::Mat(empty.instance_map()).setTo(0);
  write({empty}, GetParam().parameters);
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_P(VerifyEveryFormat, FindsNothingWrongWithHiddenAndDroppedObjects) {
  Scene scene = sceneOfBoth(0);
  scene.objects[0] = hidden(scene.objects[0]);
  scene.objects[1].dropped = true;
  cv::Mat(scene.instance_map()).setTo(0, scene.instance_map() == 1);
  write({scene}, GetParam().parameters);
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_P(VerifyEveryFormat, FindsNothingWrongAtTheImagesEdge) {
  Scene scene = sceneOfBoth(0);
  SceneObject cut = seen("a", {-20, 440, 50, 100});
  const SceneObject& whole = scene.objects[0];
  cut.id = cut.name;
  cut.class_name = cut.class_text = whole.class_name;
  cut.X_GO = cut.X_CO = whole.X_CO;
  cut.keypoints_O = whole.keypoints_O;
  cut.keypoints = whole.keypoints;
  cut.instance = 1;
  cv::Mat(scene.instance_map()).setTo(0, scene.instance_map() == 1);
  cv::Mat(scene.instance_map()).setTo(1, cut.visible_mask().whole());
  scene.objects[0] = cut;
  write({scene}, GetParam().parameters);
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_P(VerifyEveryFormat, FindsNothingWrongWithAHugeLooseBox) {
  Scene scene = sceneOfBoth(0);
  // Such a box can come from an object at the near plane, seen through a lens.
  scene.objects[0].loose_box = Box{-3.3e21, -7.1e15, 410.5, 300.25};
  write({scene}, GetParam().parameters);
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_P(VerifyEveryFormat, FindsNothingWrongWithSurfacesAtAnyDepth) {
  Scene scene = sceneOfBoth(0);
  cv::Mat depth = scene.depth();
  cv::theRNG().state = 4;
  cv::randu(depth, 0.5F, 60.0F);
  write({scene}, GetParam().parameters);
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_P(VerifyEveryFormat, FindsNothingWrongWithOddNames) {
  std::string long_name(5000, 'n');
  long_name[20] = ',';
  dataset_.classes = {{0, ".."}, {1, long_name}};
  Scene scene = sceneOfBoth(0);
  const std::vector<std::string> names = {"..", ".x.tmp"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    ObjectInfo& info = dataset_.objects[i];
    info.name = scene.objects[i].name = names[i];
    info.id = scene.objects[i].id = i == 0 ? long_name : ". 1.5 ..";
    info.class_name = scene.objects[i].class_name = dataset_.classes[i].name;
    scene.objects[i].class_text = info.class_name;
  }
  Value::Map parameters = GetParam().parameters;
  for (const char* of_classes : {"class_names", "class_ids", "label_ids"}) {
    parameters.erase(of_classes);  // they are about classes that this dataset lacks
  }
  write({scene}, parameters);
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_P(VerifyEveryFormat, FindsNothingWrongWithTwoCamerasAndSplits) {
  const std::vector<Scene> scenes =
      ofTwoCamerasAndSplits([this](std::int64_t index) { return sceneOfBoth(index); });
  write(scenes, GetParam().parameters);
  EXPECT_THAT(problems(), IsEmpty());
  EXPECT_EQ(counts_.labels, (GetParam().is_of_all_cameras ? 2 : 4) * GetParam().labels_of_a_scene);
}

TEST_P(VerifyEveryFormat, FindsNothingWrongWithClassesOfTheWorldAndParts) {
  dataset_.world_classes = {"floor", "wall"};
  dataset_.objects[1].part_names = {"handle", "lid"};
  Scene scene = sceneOfBoth(0);
  cv::Mat(scene.world_map())(cv::Rect(0, 300, 640, 100)).setTo(2);
  cv::Mat(scene.part_map()).setTo(2, scene.instance_map() == 2);
  write({scene}, GetParam().parameters);
  EXPECT_THAT(problems(), IsEmpty());
  EXPECT_THAT(remarks_, SizeIs(GetParam().remarks));
}

TEST_P(VerifyEveryFormat, FindsNothingWrongWithTwoMotions) {
  dataset_.motions = {{"walk", 0, 2, 10.0}, {"still", 2, 1, 0.0}};
  const auto writeAll = [this] {
    write({sceneOfBoth(0), sceneOfBoth(1), sceneOfBoth(2)}, GetParam().parameters);
  };
  if (GetParam().type == "RosBag") {
    EXPECT_THAT(test::messagesOf(writeAll),
                testing::Contains(testing::HasSubstr("a bag has one time line")));
    return;
  }
  writeAll();
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_P(VerifyEveryFormat, SeesALabelOfAnObjectThatIsNotThere) {
  if (GetParam().type == "SemanticKitti") {
    GTEST_SKIP() << "its labels are those of points, of which the manifest has digests alone";
  }
  write({sceneOfBoth(0), sceneOfBoth(1)}, GetParam().parameters);
  // Removes the second object from scene 1 in the manifest.
  change(
      "UPDATE scene_object SET x = NULL, y = NULL, z = NULL, qx = NULL, qy = NULL, qz = NULL, "
      "qw = NULL, distance = NULL, in_view = 0, dropped = 1, visible_pixels = 0, silhouette_pixels "
      "= "
      "0, visibility "
      "= 0, loose_left = NULL, loose_top = NULL, loose_right = NULL, loose_bottom = NULL, "
      "visible_left = NULL, visible_top = NULL, visible_right = NULL, visible_bottom = NULL, "
      "silhouette_left = NULL, silhouette_top = NULL, silhouette_right = NULL, "
      "silhouette_bottom = NULL WHERE scene = 1 AND object = 1");
  const std::vector<std::string> found = problems();
  ASSERT_THAT(found, testing::Not(IsEmpty()));
  for (const std::string& each : found) {
    EXPECT_THAT(each, testing::StartsWith("scene 1, writer 'w': found a label"));
    EXPECT_THAT(each, testing::EndsWith("that no object should have"));
  }
}

TEST_P(VerifyEveryFormat, SeesAPictureOfAnotherSize) {
  write({sceneOfBoth(0)}, GetParam().parameters);
  change("UPDATE scene SET width = 641");
  EXPECT_THAT(problems(), testing::Contains(testing::HasSubstr(
                              "is a picture of 640 x 480 pixels; it should be of its camera's "
                              "641 x 480")));
}

INSTANTIATE_TEST_SUITE_P(Formats, VerifyEveryFormat, testing::ValuesIn(formatCases()),
                         [](const auto& format) { return format.param.name; });

}  // namespace every_format_test
}  // namespace synthetic_dataset::output
