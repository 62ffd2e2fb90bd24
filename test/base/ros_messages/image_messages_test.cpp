#include "base/ros_messages/image_messages.h"

#include <cmath>
#include <cstring>

#include <gmock/gmock.h>

namespace synthetic_dataset::ros_messages {
namespace image_messages_test {

using testing::ElementsAre;

TEST(ImageMessage, HoldsThePixelsOfACutRowByRow) {
  const cv::Mat whole = (cv::Mat_<uchar>(3, 3) << 1, 2, 3, 4, 5, 6, 7, 8, 9);
  std_msgs::Header header;
  header.frame_id = "camera";
  const sensor_msgs::Image image = imageMessage(header, "mono8", whole(cv::Rect(1, 0, 2, 3)));
  EXPECT_THAT(image.data, ElementsAre(2, 3, 5, 6, 8, 9));
  EXPECT_EQ(image.width, 2U);
  EXPECT_EQ(image.height, 3U);
  EXPECT_EQ(image.step, 2U);
  EXPECT_EQ(image.encoding, "mono8");
  EXPECT_EQ(image.header.frame_id, "camera");
}

TEST(DepthMessage, HasNoNumberWhereNothingIs) {
  const cv::Mat depth = (cv::Mat_<float>(1, 3) << 1.5F, 0.0F, -2.5F);
  const sensor_msgs::Image image = depthMessage({}, depth);
  EXPECT_EQ(image.encoding, "32FC1");
  float values[3];
  ASSERT_EQ(image.data.size(), sizeof(values));
  std::memcpy(values, image.data.data(), sizeof(values));
  EXPECT_EQ(values[0], 1.5F);
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_EQ(values[2], -2.5F);
  EXPECT_EQ(depth.at<float>(1), 0.0F) << "the scene's own depth stays as it is";
}

}  // namespace image_messages_test
}  // namespace synthetic_dataset::ros_messages
