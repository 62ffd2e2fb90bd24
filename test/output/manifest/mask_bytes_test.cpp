#include "output/manifest/mask_bytes.h"

#include <random>

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include "support/error_messages.h"

namespace synthetic_dataset::output {
namespace mask_bytes_test {

using testing::ElementsAre;
using testing::HasSubstr;

const cv::Size kSize(300, 200);

void expectSame(const cv::Mat& image) {
  const Mask mask(image);
  const Mask read = maskOfBytes(maskBytes(mask), image.size());
  EXPECT_EQ(read.bounds(), mask.bounds());
  EXPECT_EQ(cv::countNonZero(read.whole() != image), 0);
}

TEST(MaskBytes, AreReadAsTheMaskThatTheyWere) {
  expectSame(cv::Mat::zeros(kSize, CV_8UC1));
  expectSame(cv::Mat(kSize, CV_8UC1, cv::Scalar(255)));
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    cv::Mat image = cv::Mat::zeros(kSize, CV_8UC1);
    for (int k = 0; k < 400; ++k) {
      image.at<uchar>(static_cast<int>(random() % 150), 10 + static_cast<int>(random() % 60)) = 255;
    }
    expectSame(image);
  }
}

TEST(MaskBytes, AreAsDocumented) {
  cv::Mat image = cv::Mat::zeros(kSize, CV_8UC1);
  image(cv::Rect(130, 5, 3, 2)).setTo(255);
  image.at<uchar>(5, 131) = 0;
  // Left 130, top 5, 3 wide, 2 high; none off, 1 on, 1 off, 4 on.
  EXPECT_THAT(maskBytes(Mask(image)),
              ElementsAre('\x82', '\x01', '\x05', '\x03', '\x02', '\x00', '\x01', '\x01', '\x04'));
}

TEST(MaskBytes, AreNotTakenWhereTheyAreOfNoMask) {
  const auto messageOf = [](const std::string& bytes) {
    return test::messagesOf([&] { (void)maskOfBytes(bytes, kSize); });
  };
  EXPECT_THAT(messageOf(""), ElementsAre(HasSubstr("is damaged")));
  EXPECT_THAT(messageOf("\x01\x01\x02\x02\x7f"), ElementsAre(HasSubstr("more pixels")));
  EXPECT_THAT(messageOf("\x01\x01\x02\x02\x01"), ElementsAre(HasSubstr("fewer pixels")));
  EXPECT_THAT(messageOf("\xff\x7f\x01\x02\x02"), ElementsAre(HasSubstr("larger than its image")));
}

}  // namespace mask_bytes_test
}  // namespace synthetic_dataset::output
