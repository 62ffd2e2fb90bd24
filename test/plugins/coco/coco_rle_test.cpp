#include "plugins/coco/coco_rle.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::coco {
namespace coco_rle_test {

// These masks as packed by pycocotools 2.0.11.

TEST(CocoRle, UnpacksABlock) {
  const cv::Mat1b mask = maskOfCocoCounts("5220003", {5, 4});
  cv::Mat1b expected(4, 5, std::uint8_t{0});
  expected(cv::Rect(1, 1, 3, 2)) = 255;
  EXPECT_EQ(cv::countNonZero(mask != expected), 0);
}

TEST(CocoRle, UnpacksTheFirstPixel) {
  const cv::Mat1b mask = maskOfCocoCounts("01c0", {5, 4});
  EXPECT_EQ(cv::countNonZero(mask), 1);
  EXPECT_EQ(mask(0, 0), 255);
}

TEST(CocoRle, UnpacksNothingAndEverything) {
  EXPECT_EQ(cv::countNonZero(maskOfCocoCounts("PP\\9", {640, 480})), 0);
  EXPECT_EQ(cv::countNonZero(maskOfCocoCounts("0PP\\9", {640, 480})), 640 * 480);
}

TEST(CocoRle, RefusesRunsOfAnotherSize) {
  EXPECT_THROW((void)maskOfCocoCounts("01c0", {5, 5}), Error);
  EXPECT_THROW((void)maskOfCocoCounts("01c0", {4, 4}), Error);
}

TEST(CocoRle, RefusesWhatIsNoPacking) {
  EXPECT_THROW((void)maskOfCocoCounts("01 c0", {5, 4}), Error);
  EXPECT_THROW((void)maskOfCocoCounts("0oooooooooooooooooooo0", {5, 4}), Error);
}

}  // namespace coco_rle_test
}  // namespace synthetic_dataset::formats::coco
