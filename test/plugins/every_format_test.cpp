#include <algorithm>
#include <filesystem>
#include <regex>

#include <gmock/gmock.h>

#include "plugins/format_cases.h"
#include "plugins/model_shapes.h"
#include "plugins/plugin_harness.h"
#include "plugins/readback/format.h"
#include "support/temporary_folder.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset {
namespace every_format_test {

namespace fs = std::filesystem;

/// Expectations for each of the package's formats.
class EveryFormat : public PluginTest, public testing::WithParamInterface<FormatCase> {
 protected:
  EveryFormat() : PluginTest("synthetic_dataset/" + GetParam().type) {
    for (const std::string name : {"a", "b"}) addObject(name);
    if (GetParam().has_lidar) addLidar();
    dataset_.classes = {{0, "cup"}};
    dataset_.setModels([](std::size_t /*object*/) {
      return cuboidModel({{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}});
    });
  }

  void addObject(const std::string& name) {
    ObjectInfo info;
    info.name = name;
    info.id = name;
    info.class_name = "cup";
    info.keypoint_count = 1;
    info.keypoint_names = {"0"};
    dataset_.objects.push_back(info);
  }

  /// A scene in which both objects are seen, side by side.
  [[nodiscard]] Scene sceneOfBoth(std::int64_t index) const {
    Scene scene = PluginTest::scene(index, {seen(dataset_.objects[0].name, {100, 100, 50, 40}),
                                            seen(dataset_.objects[1].name, {300, 100, 50, 40})});
    scene.stamp = Stamp(std::chrono::seconds(1 + index));  // a bag has no time 0
    for (SceneObject& object : scene.objects) {
      object.class_name = object.class_text = dataset_.classes[0].name;
      object.keypoints_O = {Eigen::Vector3d::Zero()};
      object.keypoints = {keypoint(Eigen::Vector2d(120.0, 110.0), 10.0, KeypointState::kVisible)};
    }
    if (GetParam().has_lidar) return withCloud(std::move(scene));
    return scene;
  }
};

TEST_P(EveryFormat, FinishesADatasetWithoutScenes) {
  load(GetParam().parameters);
  EXPECT_THAT(parameters_.errors(), testing::IsEmpty());
  EXPECT_NO_THROW(runAll({}));
}

TEST_P(EveryFormat, WritesASceneWithNothingInView) {
  load(GetParam().parameters);
  Scene empty = scene(0, {object("a"), object("b")});
  empty.stamp = Stamp(std::chrono::seconds(1));
  if (GetParam().has_lidar) empty = withCloud(std::move(empty));
  EXPECT_NO_THROW(runAll({empty}));
}

TEST_P(EveryFormat, KeepsItsFilesInItsFolderWhateverTheNames) {
  for (const std::string& name :
       {std::string("../../up"), std::string(".."), std::string("a b/c\"d'e:f#g,h&<i>"),
        std::string("\u00e4\u2615"), std::string("-"), std::string("null"),
        std::string("a\\b{}[]|>%"), std::string(300, 'n'), std::string(".x.tmp"),
        std::string("a//b/"), std::string("two\nlines\x01")}) {
    for (const fs::path& leftover : fs::directory_iterator(folder_.path()))
      fs::remove_all(leftover);
    dataset_.objects[0].name = name;
    dataset_.classes[0].name = name;
    for (ObjectInfo& object : dataset_.objects) object.class_name = name;
    load(GetParam().parameters);
    EXPECT_NO_THROW(runAll({sceneOfBoth(0)})) << name;
    for (const fs::path& entry : fs::directory_iterator(folder_.path())) {
      EXPECT_THAT(entry.filename().string(), testing::AnyOf("w", "manifest.sqlite")) << name;
    }
  }
}

TEST_P(EveryFormat, WritesScenesOfTwoCamerasAndSplits) {
  const std::vector<Scene> scenes =
      ofTwoCamerasAndSplits([this](std::int64_t index) { return sceneOfBoth(index); });
  load(GetParam().parameters);
  EXPECT_NO_THROW(runAll(scenes));
}

INSTANTIATE_TEST_SUITE_P(Formats, EveryFormat, testing::ValuesIn(formatCases()),
                         [](const auto& format) { return format.param.name; });

TEST(Formats, HaveAReaderAndATestEach) {
  const std::regex kName("class name=\"(synthetic_dataset/(\\w+))\"");
  const std::string xml = test::readFile(test::pluginXml());
  const std::vector<FormatCase> cases = formatCases();
  int count = 0;
  for (std::sregex_iterator match(xml.begin(), xml.end(), kName), end; match != end; ++match) {
    ++count;
    EXPECT_NE(formats::formatOf((*match)[1]), nullptr) << (*match)[1];
    EXPECT_TRUE(std::any_of(cases.begin(), cases.end(), [&](const FormatCase& each) {
      return each.type == (*match)[2];
    })) << (*match)[1];
  }
  EXPECT_GT(count, 0);
  EXPECT_EQ(formats::formatOf("synthetic_dataset/Yol"), nullptr);
}

}  // namespace every_format_test
}  // namespace synthetic_dataset
