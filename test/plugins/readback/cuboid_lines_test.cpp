#include "plugins/readback/cuboid_lines.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

namespace synthetic_dataset::formats {
namespace cuboid_lines_test {

using testing::IsEmpty;
using testing::SizeIs;

const CameraModel kCamera(640, 480, {500.0, 500.0, 320.0, 240.0}, 0.05, 100.0);
const Cuboid kCube{{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}};

Pose ahead(double z) {
  Pose X_CO = Pose::Identity();
  X_CO.translation().z() = z;
  return X_CO;
}

TEST(CuboidLines, RunAlongTheTwelveEdges) {
  const auto lines = cuboidLines(kCube, ahead(6.0), kCamera);
  ASSERT_THAT(lines, SizeIs(12 * 16));
  // The near face, z = 5: 100 px a metre. Each piece is 2 m / 16 long.
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const auto& line) {
    return cv::norm(line[0] - cv::Point2d(220.0, 140.0)) < 1e-9 &&
           cv::norm(line[1] - cv::Point2d(232.5, 140.0)) < 1e-9;
  }));
}

TEST(CuboidLines, LeaveOutWhatIsBehindTheCamera) {
  // The far face and half of the edges towards the camera.
  const std::size_t count = cuboidLines(kCube, ahead(0.0), kCamera).size();
  EXPECT_GE(count, 4U * 16U + 4U * 6U);
  EXPECT_LE(count, 4U * 16U + 4U * 8U);
  EXPECT_THAT(cuboidLines(kCube, ahead(-5.0), kCamera), IsEmpty());
}

}  // namespace cuboid_lines_test
}  // namespace synthetic_dataset::formats
