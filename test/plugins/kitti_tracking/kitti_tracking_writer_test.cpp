#include <cmath>

#include <gmock/gmock.h>

#include "plugins/plugin_harness.h"

namespace synthetic_dataset {
namespace kitti_tracking_writer_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class KittiTracking : public PluginTest {
 protected:
  KittiTracking() : PluginTest("synthetic_dataset/KittiTracking") {
    dataset_.classes = {{0, "rover_class"}};
    dataset_.motions = {{"walk", 0, 4, 5.0}};
  }

  /// A box of 4 x 2 x 1.5 m that stands upright, its x axis along the camera's.
  [[nodiscard]] static SceneObject upright(const cv::Rect& pixels) {
    SceneObject object = seen("rover", pixels);
    object.cuboid_O = {{-2.0, -1.0, 0.0}, {2.0, 1.0, 1.5}};
    object.X_CO->linear() << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, -0.0, 1.0, 0.0;
    object.X_CO->translation() = Eigen::Vector3d(0.0, 1.0, 10.0);
    return object;
  }

  [[nodiscard]] std::string read(const std::string& path) const {
    return test::readFile(folder() + path);
  }
};

TEST_F(KittiTracking, WritesSeventeenColumnsFromFrame0On) {
  load({});
  runAll({scene(0, {}), scene(1, {upright({100, 80, 50, 40})})});
  EXPECT_EQ(read("training/label_02/0000.txt"),
            "1 0 rover_class 0 0 0.000000 100.000000 80.000000 150.000000 120.000000 1.500000 "
            "2.000000 4.000000 0.000000 1.000000 10.000000 0.000000\n");
  EXPECT_EQ(read("training/image_02/0000/000001.png"), read("scenes/00000001.png"));
  EXPECT_EQ(read("evaluate_tracking.seqmap.train"), "0000 empty 000000 000002\n");
  EXPECT_THAT(read("training/calib/0000.txt"), HasSubstr("P2: 500.000000 0.000000 320.000000"));
}

TEST_F(KittiTracking, HasWholeNumbersForTruncation) {
  load({});
  SceneObject object = upright({100, 80, 50, 40});
  object.pixels.silhouette_in_image = 1400;  // of 2000
  runAll({scene(0, {object})});
  EXPECT_THAT(read("training/label_02/0000.txt"), StartsWith("0 0 rover_class 1 "));
}

TEST_F(KittiTracking, GivesWhatIsDroppedNoTrack) {
  load({});
  SceneObject dropped = upright({100, 80, 50, 40});
  dropped.dropped = true;
  runAll({scene(0, {dropped})});
  EXPECT_EQ(read("training/label_02/0000.txt"),
            "0 -1 DontCare -1 -1 -10 100.000000 80.000000 150.000000 120.000000 -1000 -1000 -1000 "
            "-10 -1 -1 -1\n");
}

TEST_F(KittiTracking, ListsTheSequencesOfEachSplit) {
  dataset_.splits = {{"train", 1}, {"val", 2}};
  load({});
  std::vector<Scene> scenes;
  for (int i = 0; i < 3; ++i) {
    scenes.push_back(scene(i, {upright({100, 80, 50, 40})}));
    scenes.back().split = i == 0 ? "train" : "val";
  }
  runAll(scenes);
  EXPECT_EQ(read("evaluate_tracking.seqmap.train"), "0000 empty 000000 000001\n");
  EXPECT_EQ(read("evaluate_tracking.seqmap.val"), "0001 empty 000000 000002\n");
  EXPECT_EQ(read("frames.txt"),
            "0000 0 scenes/00000000.png\n0001 0 scenes/00000001.png\n0001 1 "
            "scenes/00000002.png\n");
}

TEST_F(KittiTracking, WarnsOfTypesThatTrackEvalRefuses) {
  dataset_.classes = {{0, "rover_class"}, {1, "Van"}};
  EXPECT_THAT(load({}).warnings(), ElementsAre(testing::AllOf(
                                       HasSubstr("TrackEval does not know the type 'rover_class'"),
                                       HasSubstr("`class_names: {\"rover_class\": Car}`"))));
  EXPECT_THAT(load({{"class_names", Value::Map{{"rover_class", "Car"}}}}).warnings(),
              testing::IsEmpty());
}

TEST_F(KittiTracking, RefusesIntrinsicsThatVary) {
  dataset_.cameras[0].intrinsics_vary = true;
  EXPECT_ANY_THROW(load({}));
}

}  // namespace kitti_tracking_writer_test
}  // namespace synthetic_dataset
