#include "plugins/readback/camera_drawing.h"

#include <gmock/gmock.h>

#include "plugins/reader_harness.h"
#include "synthetic_dataset/cuboid.h"

namespace synthetic_dataset::formats {
namespace camera_drawing_test {

const Intrinsics kCamera{100.0, 100.0, 50.0, 40.0};

class CameraDrawing : public ReaderTest {
 protected:
  CameraDrawing() : ReaderTest("Kitti") {}
};

TEST_F(CameraDrawing, ProjectsEdges) {
  DrawnLabel label;
  addCuboid(label, kCamera, Cuboid{{-1.0, -1.0, 5.0}, {1.0, 1.0, 10.0}}.corners());
  EXPECT_EQ(label.lines.size(), 12U);
  EXPECT_TRUE(hasLine(label, {30.0, 20.0}, {70.0, 20.0}));   // 20 px a metre at 5 m
  EXPECT_TRUE(hasLine(label, {30.0, 20.0}, {40.0, 30.0}));   // 10 px a metre at 10 m
  EXPECT_FALSE(hasLine(label, {30.0, 20.0}, {70.0, 60.0}));  // a diagonal
}

TEST_F(CameraDrawing, CutsLinesAtTheCamera) {
  DrawnLabel label;
  addLine(label, kCamera, {1.0, 0.0, 10.0}, {1.0, 0.0, -10.0});
  ASSERT_EQ(label.lines.size(), 1U);
  EXPECT_NEAR(label.lines[0][1].x, 60.0, 1e-9);
  EXPECT_NEAR(label.lines[0][0].x, 50.0 + 100.0 / 0.01, 1e-6);
  addLine(label, kCamera, {1.0, 0.0, -1.0}, {1.0, 0.0, -10.0});
  EXPECT_EQ(label.lines.size(), 1U);
}

}  // namespace camera_drawing_test
}  // namespace synthetic_dataset::formats
