#include "plugins/shared/mask_rle.h"

#include <gmock/gmock.h>
#include <opencv2/imgproc.hpp>

#include "synthetic_dataset/mask.h"

namespace synthetic_dataset {
namespace mask_rle_test {

using testing::ElementsAre;

cv::Mat1b empty(int rows, int columns) { return cv::Mat1b(rows, columns, std::uint8_t{0}); }

std::vector<std::int64_t> runsOf(const cv::Mat& mask) { return masks::columnRuns(Mask(mask)); }

std::string countsOf(const cv::Mat& mask) { return masks::cocoCounts(runsOf(mask)); }

TEST(MaskRle, RunsDownTheColumnsFromZerosOn) {
  cv::Mat1b mask = empty(4, 5);
  mask(cv::Rect(1, 1, 3, 2)) = 255;
  // Column 0 and a pixel; then two on, two off, three times; the last column.
  EXPECT_THAT(runsOf(mask), ElementsAre(5, 2, 2, 2, 2, 2, 5));
}

TEST(MaskRle, BeginsWithARunOfNothingWhereTheFirstPixelIsOn) {
  cv::Mat1b mask = empty(2, 3);
  mask(0, 0) = 1;
  EXPECT_THAT(runsOf(mask), ElementsAre(0, 1, 5));
}

TEST(MaskRle, RunsOnFromTheFootOfAColumnToTheHeadOfTheNext) {
  cv::Mat1b mask = empty(3, 3);
  mask(2, 0) = mask(0, 1) = 255;
  EXPECT_THAT(runsOf(mask), ElementsAre(2, 2, 5));
}

TEST(MaskRle, EndsAColumnThatRunsToTheFootAtTheHeadOfTheNext) {
  cv::Mat1b mask = empty(3, 3);
  mask(cv::Rect(0, 1, 3, 2)) = 255;
  EXPECT_THAT(runsOf(mask), ElementsAre(1, 2, 1, 2, 1, 2));
}

TEST(MaskRle, EndsAFullColumnAtTheNextEmptyOne) {
  cv::Mat1b mask = empty(2, 3);
  mask(cv::Rect(1, 0, 1, 2)) = 255;
  EXPECT_THAT(runsOf(mask), ElementsAre(2, 2, 2));
}

TEST(MaskRle, ReadsAPartOfABiggerImage) {
  cv::Mat1b image = empty(10, 10);
  image(4, 4) = 255;
  EXPECT_THAT(runsOf(image(cv::Rect(3, 3, 3, 3))), ElementsAre(4, 1, 4));
}

// The same masks as encoded by pycocotools 2.0.11.

TEST(MaskRle, PacksASmallBlockAsPycocotools) {
  cv::Mat1b mask = empty(4, 5);
  mask(cv::Rect(1, 1, 3, 2)) = 255;
  EXPECT_EQ(countsOf(mask), "5220003");
}

TEST(MaskRle, PacksTheFirstPixelAsPycocotools) {
  cv::Mat1b mask = empty(4, 5);
  mask(0, 0) = 255;
  EXPECT_EQ(countsOf(mask), "01c0");
}

TEST(MaskRle, PacksNothingAsPycocotools) { EXPECT_EQ(countsOf(empty(480, 640)), "PP\\9"); }

TEST(MaskRle, PacksAFullImageAsPycocotools) {
  cv::Mat1b mask = empty(480, 640);
  mask = 255;
  EXPECT_EQ(countsOf(mask), "0PP\\9");
}

TEST(MaskRle, PacksNegativeDifferencesWithTheirSign) {
  // 3 - 100 = -97 = ...11100 11111 in groups of five bits: 31 with more, then 28 whose sign bit
  // is set: chr(48 + 31 + 32) = 'o', chr(48 + 28) = 'L'. 100 = 00011 00100: 'T', '3'.
  EXPECT_EQ(masks::cocoCounts({1, 100, 1, 3}), "1T31oL");
}

}  // namespace mask_rle_test
}  // namespace synthetic_dataset
