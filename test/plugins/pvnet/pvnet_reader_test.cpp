#include <cstring>

#include <gmock/gmock.h>

#include "plugins/reader_harness.h"
#include "synthetic_dataset/cuboid.h"

namespace synthetic_dataset::formats {
namespace pvnet_reader_test {

class PvNetReader : public ReaderTest {
 protected:
  PvNetReader() : ReaderTest("PvNet") {}
};

TEST_F(PvNetReader, ReadsPointsAndPose) {
  const auto file = image("rover/scenes/rgb/00000000.png");
  picture("rover/scenes/mask/00000000.png", cv::Mat(80, 100, CV_8UC1, cv::Scalar(0)));
  folder_.write("rover/camera.txt", "100 0 50\n0 100 40\n0 0 1\n");
  std::string corners;
  for (const Eigen::Vector3d& corner : Cuboid{{-1, -1, -2.5}, {1, 1, 2.5}}.corners()) {
    for (int axis = 0; axis < 3; ++axis) corners += std::to_string(corner[axis]) + " ";
    corners += "\n";
  }
  folder_.write("rover/corners.txt", corners);
  folder_.write("rover/fps.txt", "1 0 -2.5\n");
  const double pose[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 7.5};
  std::string bytes(sizeof pose, ' ');
  std::memcpy(&bytes[0], pose, sizeof pose);
  folder_.write("rover/scenes/pose/00000000.npy", "header\n" + bytes);
  const LabelledPicture read = readScene({file});
  ASSERT_EQ(read.labels.size(), 1U);
  EXPECT_EQ(read.labels[0].caption, "rover");
  EXPECT_TRUE(hasLine(read.labels[0], {30.0, 20.0}, {70.0, 20.0}));
  EXPECT_EQ(read.labels[0].keypoints.at(0), cv::Point2d(70.0, 40.0));
}

}  // namespace pvnet_reader_test
}  // namespace synthetic_dataset::formats
