#include <algorithm>
#include <filesystem>

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include "plugins/plugin_harness.h"
#include "plugins/readback/format.h"
#include "support/error_messages.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset {
namespace ros_bag_reader_test {

using testing::HasSubstr;

class RosBagReader : public PluginTest {
 protected:
  RosBagReader() : PluginTest("synthetic_dataset/RosBag") {}

  /// Scenes of two cameras at two times; the rover stands 10 m before the camera.
  void writeScenes() {
    scenes_ = ofTwoCamerasAndSplits([](std::int64_t index) {
      SceneObject rover = seen("rover", {100, 100, 50, static_cast<int>(10 + index)});
      rover.X_GO->translation().x() = 1.0;
      Scene made = scene(index, {object("wall"), rover});
      made.X_GC.translation().x() = 1.0;
      return made;
    });
    load({});
    runAll(scenes_);
  }

  [[nodiscard]] formats::LabelledPicture read(const Scene& scene) const {
    return formats::formatOf("synthetic_dataset/RosBag")
        ->read({folder(),
                scene.name,
                scene.camera_index,
                scene.stamp,
                {folder() + "images/" + scene.name + ".png",
                 folder() + "instances/" + scene.name + ".png"}});
  }

  std::vector<Scene> scenes_;
};

TEST_F(RosBagReader, ReadsMasksNamesAndBoxes) {
  writeScenes();
  for (std::size_t i = 0; i < scenes_.size(); ++i) {
    const formats::LabelledPicture picture = read(scenes_[i]);
    EXPECT_EQ(picture.image.size(), cv::Size(640, 480));
    ASSERT_EQ(picture.labels.size(), 1U);
    const formats::DrawnLabel& label = picture.labels.front();
    EXPECT_EQ(label.caption, "rover_class");
    EXPECT_EQ(label.object_name, "rover");
    EXPECT_EQ(cv::countNonZero(label.mask), 50 * (10 + static_cast<int>(i)));
  }
}

TEST_F(RosBagReader, DrawsBoxesAsTheCameraSeesThem) {
  writeScenes();
  const auto lines = read(scenes_[3]).labels.at(0).lines;
  // The nearest edges of the cube of 1 m are 9.5 m away.
  const double half = 0.5 * 500.0 / 9.5;
  const cv::Point2d corner(320.0 - half, 240.0 - half);
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(),
                          [&](const auto& line) { return cv::norm(line[0] - corner) < 1e-6; }));
}

TEST_F(RosBagReader, NamesTheFolderWithoutABag) {
  writeScenes();
  std::filesystem::remove(folder() + "dataset.bag");
  EXPECT_THAT(test::messagesOf([&] { (void)read(scenes_[0]); }),
              testing::ElementsAre(HasSubstr("no bag is there")));
}

TEST_F(RosBagReader, NamesAFileThatIsNoBag) {
  writeScenes();
  (void)folder_.write("w/a.bag", "#ROSBAG V2.0\n");
  EXPECT_THAT(test::messagesOf([&] { (void)read(scenes_[0]); }),
              testing::ElementsAre(HasSubstr("w/a.bag': ")));
}

}  // namespace ros_bag_reader_test
}  // namespace synthetic_dataset
