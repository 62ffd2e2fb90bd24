#include <cmath>
#include <cstring>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "plugins/readback/camera_drawing.h"
#include "plugins/readback/format_readers.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/cuboid.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::readback {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const Intrinsics kCamera{100.0, 100.0, 50.0, 40.0};

/// Whether one of a label's lines goes from one place to the other, either way.
bool hasLine(const DrawnLabel& label, const cv::Point2d& a, const cv::Point2d& b) {
  const auto isNear = [](const cv::Point2d& p, const cv::Point2d& q) {
    return std::hypot(p.x - q.x, p.y - q.y) < 1e-6;
  };
  for (const auto& [from, to] : label.lines) {
    if ((isNear(from, a) && isNear(to, b)) || (isNear(from, b) && isNear(to, a))) return true;
  }
  return false;
}

TEST(CameraDrawing, ProjectsEdges) {
  DrawnLabel label;
  addCuboid(label, kCamera, Cuboid{{-1.0, -1.0, 5.0}, {1.0, 1.0, 10.0}}.corners());
  EXPECT_EQ(label.lines.size(), 12U);
  EXPECT_TRUE(hasLine(label, {30.0, 20.0}, {70.0, 20.0}));   // 20 px a metre at 5 m
  EXPECT_TRUE(hasLine(label, {30.0, 20.0}, {40.0, 30.0}));   // 10 px a metre at 10 m
  EXPECT_FALSE(hasLine(label, {30.0, 20.0}, {70.0, 60.0}));  // a diagonal
}

TEST(CameraDrawing, CutsLinesAtTheCamera) {
  DrawnLabel label;
  addLine(label, kCamera, {1.0, 0.0, 10.0}, {1.0, 0.0, -10.0});
  ASSERT_EQ(label.lines.size(), 1U);
  EXPECT_NEAR(label.lines[0][1].x, 60.0, 1e-9);
  EXPECT_NEAR(label.lines[0][0].x, 50.0 + 100.0 / 0.01, 1e-6);
  addLine(label, kCamera, {1.0, 0.0, -1.0}, {1.0, 0.0, -10.0});
  EXPECT_EQ(label.lines.size(), 1U);
}

class PoseReaders : public testing::Test {
 protected:
  std::filesystem::path picture(const std::string& path, const cv::Mat& pixels) {
    const auto file = folder_.write(path, "");
    cv::imwrite(file.string(), pixels);
    return file;
  }

  std::filesystem::path image(const std::string& path) {
    return picture(path, cv::Mat(80, 100, CV_8UC3, cv::Scalar::all(9)));
  }

  [[nodiscard]] WrittenScene sceneOf(const std::vector<std::filesystem::path>& files) const {
    return {folder_.path(), "00000000", 0, files};
  }

  test::TemporaryFolder folder_;
};

TEST_F(PoseReaders, DrawKittisBoxes) {
  const auto file = image("training/image_2/000000.png");
  folder_.write("training/calib/000000.txt", "P2: 100 0 50 0 0 100 40 0 0 0 1 0\n");
  // Turned by -90 degrees: its length of 4 m lies along the camera's z.
  folder_.write("training/label_2/000000.txt",
                "Car 0 0 0 10 20 30 40 1 2 4 0 1 8 -1.5707963267948966\n"
                "DontCare -1 -1 -10 1 2 3 4 -1 -1 -1 -1000 -1000 -1000 -10\n");
  const LabelledPicture read = readKitti(sceneOf({file}));
  ASSERT_EQ(read.labels.size(), 2U);
  EXPECT_EQ(read.labels[0].caption, "Car");
  EXPECT_EQ(read.labels[0].box->left, 9.5);
  EXPECT_EQ(read.labels[0].box->bottom, 39.5);
  // The near lower edge: 1 m to each side, 1 m down, 6 m away; the upper far one is 10 m away.
  EXPECT_TRUE(hasLine(read.labels[0], {50.0 - 100.0 / 6, 40.0 + 100.0 / 6},
                      {50.0 + 100.0 / 6, 40.0 + 100.0 / 6}));
  EXPECT_TRUE(hasLine(read.labels[0], {40.0, 40.0}, {60.0, 40.0}));
  EXPECT_TRUE(read.labels[1].lines.empty());
}

TEST_F(PoseReaders, NameAKittiFileThatIsNotAsItShouldBe) {
  const auto file = image("training/image_2/000000.png");
  folder_.write("training/calib/000000.txt", "P0: 1\n");
  folder_.write("training/label_2/000000.txt", "");
  EXPECT_THAT([&] { (void)readKitti(sceneOf({file})); },
              ThrowsMessage<Error>(HasSubstr("000000.txt': found no line of 'P2:'")));
}

TEST_F(PoseReaders, DrawBopsMasksBoxesAndModels) {
  const auto file = image("train/000003/rgb/000012.png");
  picture("train/000003/mask_visib/000012_000000.png", cv::Mat(80, 100, CV_8UC1, cv::Scalar(255)));
  folder_.write("train/000003/scene_camera.json",
                R"({"12": {"cam_K": [100, 0, 50, 0, 100, 40, 0, 0, 1]}})");
  folder_.write("train/000003/scene_gt.json",
                R"({"12": [{"obj_id": 7, "cam_R_m2c": [1, 0, 0, 0, 1, 0, 0, 0, 1],
                            "cam_t_m2c": [0, 0, 7500]}]})");
  folder_.write("train/000003/scene_gt_info.json", R"({"12": [{"bbox_obj": [10, 20, 4, 5]}]})");
  folder_.write("models/models_info.json",
                R"({"7": {"min_x": -1000, "min_y": -1000, "min_z": -2500, "size_x": 2000,
                          "size_y": 2000, "size_z": 5000}})");
  const LabelledPicture read = readBop(sceneOf({file}));
  ASSERT_EQ(read.labels.size(), 1U);
  EXPECT_EQ(read.labels[0].box->left, 9.5);
  EXPECT_EQ(read.labels[0].box->right, 14.5);
  EXPECT_EQ(cv::countNonZero(read.labels[0].mask), 8000);
  EXPECT_TRUE(hasLine(read.labels[0], {30.0, 20.0}, {70.0, 20.0}));  // 5 m away
}

TEST_F(PoseReaders, NameABopFileThatLacksTheImage) {
  const auto file = image("train/000003/rgb/000012.png");
  folder_.write("train/000003/scene_camera.json", "{}");
  EXPECT_THAT([&] { (void)readBop(sceneOf({file})); },
              ThrowsMessage<Error>(HasSubstr("scene_camera.json'")));
}

TEST_F(PoseReaders, DrawPvNetsPointsAndPose) {
  const auto file = image("rover/scenes/rgb/00000000.png");
  picture("rover/scenes/mask/00000000.png", cv::Mat(80, 100, CV_8UC1, cv::Scalar(0)));
  folder_.write("rover/camera.txt", "100 0 50\n0 100 40\n0 0 1\n");
  std::string corners;
  for (const Eigen::Vector3d& corner : Cuboid{{-1, -1, -2.5}, {1, 1, 2.5}}.corners()) {
    for (const double number : corner) corners += std::to_string(number) + " ";
    corners += "\n";
  }
  folder_.write("rover/corners.txt", corners);
  folder_.write("rover/fps.txt", "1 0 -2.5\n");
  const double pose[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 7.5};
  std::string bytes(sizeof pose, ' ');
  std::memcpy(&bytes[0], pose, sizeof pose);
  folder_.write("rover/scenes/pose/00000000.npy", "header\n" + bytes);
  const LabelledPicture read = readPvNet(sceneOf({file}));
  ASSERT_EQ(read.labels.size(), 1U);
  EXPECT_EQ(read.labels[0].caption, "rover");
  EXPECT_TRUE(hasLine(read.labels[0], {30.0, 20.0}, {70.0, 20.0}));
  EXPECT_EQ(read.labels[0].keypoints.at(0), cv::Point2d(70.0, 40.0));
}

TEST_F(PoseReaders, DrawDopesCuboidsInBothStyles) {
  const auto file = image("00000000.png");
  const std::string places = "[[1, 1], [5, 1], [5, 5], [1, 5], [2, 2], [6, 2], [6, 6], [2, 6]";
  for (const std::string& rest :
       {std::string(", [3, 4]], \"bounding_box_minx_maxx_miny_maxy\": [10, 13, 20, 24]"),
        std::string("], \"projected_cuboid_centroid\": [3, 4], \"bounding_box\": {"
                    "\"top_left\": [20, 10], \"bottom_right\": [25, 14]}")}) {
    const auto labels = folder_.write(
        "00000000.json",
        "{\"objects\": [{\"class\": \"a\", \"projected_cuboid\": " + places + rest + "}]}");
    const LabelledPicture read = readDope(sceneOf({labels, file}));
    ASSERT_EQ(read.labels.size(), 1U);
    EXPECT_EQ(read.labels[0].lines.size(), 12U);
    EXPECT_TRUE(hasLine(read.labels[0], {1, 5}, {1, 1}));
    EXPECT_TRUE(hasLine(read.labels[0], {5, 5}, {6, 6}));
    EXPECT_EQ(read.labels[0].keypoints.at(0), cv::Point2d(3.0, 4.0));
    EXPECT_EQ(read.labels[0].box->left, 9.5);
    EXPECT_EQ(read.labels[0].box->right, 13.5);
    EXPECT_EQ(read.labels[0].box->top, 19.5);
    EXPECT_EQ(read.labels[0].box->bottom, 24.5);
  }
}

}  // namespace
}  // namespace synthetic_dataset::readback
