#include "plugins/readback/cloud_panel.h"

#include <cmath>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include "synthetic_dataset/cuboid.h"

namespace synthetic_dataset::formats {
namespace cloud_panel_test {

/// Points around the scanner.
LabelledCloud around(int count) {
  LabelledCloud cloud;
  cloud.lidar = "top";
  for (int i = 0; i < count; ++i) {
    const float angle = 6.28F * static_cast<float>(i) / static_cast<float>(count);
    cloud.points.emplace_back().position_S = {5.0F * std::cos(angle), 5.0F * std::sin(angle), 0.0F};
  }
  return cloud;
}

TEST(CloudPanel, IsOfTheSameSizeWhateverTheCloudIs) {
  LabelledCloud crowded = around(100);
  for (std::uint16_t i = 1; i <= 200; ++i) {
    crowded.classes[i] = "class " + std::to_string(i);
    crowded.objects[i] = {crowded.classes[i], "object " + std::to_string(i),
                          Cuboid{{1.0, 1.0, 0.0}, {2.0, 2.0, 1.0}}.corners()};
    crowded.points[i % 100].number = i;
  }
  const cv::Size size = drawCloud({}, {}).size();
  EXPECT_EQ(drawCloud(around(1), {}).size(), size);
  EXPECT_EQ(drawCloud(crowded, {}).size(), size);
}

TEST(CloudPanel, LeavesOutPointsThatAreNoNumbers) {
  LabelledCloud cloud = around(100);
  const cv::Mat without = drawCloud(cloud, {});
  cloud.points.emplace_back().position_S.x() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(cv::norm(drawCloud(cloud, {}), without, cv::NORM_INF), 0.0);
}

TEST(CloudPanel, SaysHowManyRaysReturned) {
  LabelledCloud cloud = around(100);
  const cv::Mat without = drawCloud(cloud, {});
  cloud.rays = 200;
  EXPECT_GT(cv::norm(drawCloud(cloud, {}), without, cv::NORM_INF), 0.0);
}

}  // namespace cloud_panel_test
}  // namespace synthetic_dataset::formats
