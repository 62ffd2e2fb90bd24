#include "run/pictures/map_paper.h"

#include <gtest/gtest.h>

namespace synthetic_dataset::run {
namespace map_paper_test {

const cv::Scalar kRed(0, 0, 255);

bool isRed(const cv::Mat& picture, int u, int v) {
  return picture.at<cv::Vec3b>(v, u) == cv::Vec3b(0, 0, 255);
}

/// A map of 11 m by 5.5 m, with 100 pixels per metre.
MapPaper paper() {
  return MapPaper(Eigen::AlignedBox2d(Eigen::Vector2d(-1, -2), Eigen::Vector2d(10, 3.5)));
}

TEST(MapPaper, HasXToTheRightAndYUp) {
  MapPaper map = paper();
  map.dot({9.0, 3.0, 7.0}, kRed);
  const cv::Mat picture = map.finish({});
  EXPECT_EQ(picture.cols, 1100);
  EXPECT_TRUE(isRed(picture, 1000, 50));
  EXPECT_FALSE(isRed(picture, 1000, 500));
}

TEST(MapPaper, FillsPolygonsInMetres) {
  MapPaper map = paper();
  map.fill({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, kRed);
  const cv::Mat picture = map.finish({});
  EXPECT_TRUE(isRed(picture, 105, 345)) << "just inside of its lower left corner";
  EXPECT_FALSE(isRed(picture, 95, 345));
  EXPECT_FALSE(isRed(picture, 105, 355));
  EXPECT_TRUE(isRed(picture, 295, 255));
}

TEST(MapPaper, KeepsWhatIsFarAwayOutside) {
  MapPaper map = paper();
  map.line({{-1e9, 0, 0}, {1e9, 0, 0}}, kRed);
  map.name("far away", {1e9, 1e9, 0}, kRed);
  EXPECT_TRUE(isRed(map.finish({}), 550, 350));
}

TEST(MapPaper, HasAScaleOfARoundLength) {
  const cv::Mat picture = paper().finish({});
  // A fifth of the width is 2.2 m: the scale has 2 m.
  const auto isInk = [&](int u) { return picture.at<cv::Vec3b>(570, u)[0] < 100; };
  EXPECT_TRUE(isInk(12) && isInk(110) && isInk(212));
  EXPECT_FALSE(isInk(225));
}

}  // namespace map_paper_test
}  // namespace synthetic_dataset::run
