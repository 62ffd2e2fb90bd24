#include "plugins/ultralytics/oriented_box.h"

#include <gmock/gmock.h>
#include <opencv2/imgproc.hpp>

#include "synthetic_dataset/mask.h"

namespace synthetic_dataset {
namespace oriented_box_test {

using testing::UnorderedElementsAre;

MATCHER_P2(At, x, y, "") { return (arg - Eigen::Vector2d(x, y)).norm() < 1e-9; }

cv::Mat maskOf(const std::vector<cv::Point>& pixels, const cv::Size& size = {40, 30}) {
  cv::Mat mask(size, CV_8UC1, cv::Scalar(0));
  for (const cv::Point& pixel : pixels) mask.at<uchar>(pixel) = 255;
  return mask;
}

TEST(OrientedBox, IsNothingForAnEmptyMask) {
  EXPECT_FALSE(orientedBox(Mask(maskOf({}))).has_value());
}

TEST(OrientedBox, OfOnePixelIsThePixel) {
  EXPECT_THAT(orientedBox(Mask(maskOf({{7, 5}}))).value(),
              UnorderedElementsAre(At(7, 5), At(8, 5), At(8, 6), At(7, 6)));
}

TEST(OrientedBox, OfAnUprightRectangleIsItself) {
  cv::Mat mask = maskOf({});
  mask(cv::Rect(4, 3, 10, 6)).setTo(255);
  EXPECT_THAT(orientedBox(Mask(mask)).value(),
              UnorderedElementsAre(At(4, 3), At(14, 3), At(14, 9), At(4, 9)));
}

TEST(OrientedBox, OfTheWholeImageIsTheImage) {
  const cv::Mat mask(30, 40, CV_8UC1, cv::Scalar(255));
  EXPECT_THAT(orientedBox(Mask(mask)).value(),
              UnorderedElementsAre(At(0, 0), At(40, 0), At(40, 30), At(0, 30)));
}

TEST(OrientedBox, TurnsWithThePixels) {
  // The hull of three pixels on a diagonal, centred at (11.5, 11.5), is as long as three diagonals
  // and as wide as one: half the sides are (1.5, 1.5) and (-0.5, 0.5).
  EXPECT_THAT(orientedBox(Mask(maskOf({{10, 10}, {11, 11}, {12, 12}}))).value(),
              UnorderedElementsAre(At(10.5, 9.5), At(13.5, 12.5), At(12.5, 13.5), At(9.5, 10.5)));
}

TEST(OrientedBox, GoesRoundItsCornersClockwiseOnTheScreen) {
  const auto corners = orientedBox(Mask(maskOf({{10, 10}, {11, 11}, {12, 12}}))).value();
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d in = corners[(i + 1) % 4] - corners[i];
    const Eigen::Vector2d out = corners[(i + 2) % 4] - corners[(i + 1) % 4];
    EXPECT_GT(in.x() * out.y() - in.y() * out.x(), 0.0);
    EXPECT_NEAR(in.dot(out), 0.0, 1e-12);
  }
}

TEST(OrientedBox, HoldsAllPixelsAtTheImagesEdgeWhereThatFitsWell) {
  // A block at the image's left edge whose right side leans: along that side, the rectangle would
  // reach past the edge.
  cv::Mat mask = maskOf({});
  mask(cv::Rect(0, 10, 10, 5)).setTo(255);
  mask(cv::Rect(0, 15, 11, 5)).setTo(255);
  EXPECT_THAT(orientedBox(Mask(mask)).value(),
              UnorderedElementsAre(At(0, 10), At(11, 10), At(11, 20), At(0, 20)));
}

TEST(OrientedBox, HoldsAllPixelsOfWhatIsWhollyInTheImage) {
  // One pixel from the image's corner, where the least box would reach past its edges.
  const auto corners =
      orientedBox(Mask(maskOf({{1, 1}, {5, 1}, {1, 5}, {20, 22}, {22, 20}}))).value();
  std::vector<cv::Point2f> polygon;
  for (const Eigen::Vector2d& corner : corners) {
    polygon.emplace_back(static_cast<float>(corner.x()), static_cast<float>(corner.y()));
  }
  for (const cv::Point2f& pixel : {cv::Point2f(1, 1), {6, 1}, {1, 6}, {20, 23}, {23, 20}}) {
    EXPECT_GT(cv::pointPolygonTest(polygon, pixel, true), -1e-3) << pixel;
  }
}

TEST(OrientedBox, IsCutBackAtTheImagesEdgeWhereItFitsBadlyOtherwise) {
  // The same in the image's corner, where (0.5, -0.5) and (-0.5, 0.5) would be the box's corners.
  // Moved by half a step, they are on the edge. The box then lacks a triangle of 0.5 of the hull's
  // 5, an intersection over union of 4.5 / 5.5; that of the upright square would be 5 / 9.
  EXPECT_THAT(orientedBox(Mask(maskOf({{0, 0}, {1, 1}, {2, 2}}))).value(),
              UnorderedElementsAre(At(1, 0), At(3.5, 2.5), At(2.5, 3.5), At(0, 1)));
}

TEST(OrientedBox, HoldsAllPixelsAwayFromTheEdgeAndNoOtherIsSmaller) {
  cv::RNG random(5);
  for (int i = 0; i < 20; ++i) {
    cv::Mat mask = maskOf({}, {100, 100});
    cv::ellipse(
        mask, cv::RotatedRect(cv::Point2f(50, 50), cv::Size2f(40, 15), random.uniform(0.F, 180.F)),
        255, cv::FILLED);
    const auto corners = orientedBox(Mask(mask)).value();
    std::vector<cv::Point2f> polygon;
    for (const Eigen::Vector2d& corner : corners) {
      polygon.emplace_back(static_cast<float>(corner.x()), static_cast<float>(corner.y()));
    }
    std::vector<cv::Point> pixels;
    cv::findNonZero(mask, pixels);
    std::vector<cv::Point2f> pixel_corners;
    for (const cv::Point& pixel : pixels) {
      for (const cv::Point& step : {cv::Point(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
        pixel_corners.emplace_back(pixel + step);
        EXPECT_GT(cv::pointPolygonTest(polygon, pixel_corners.back(), true), -1e-3);
      }
    }
    const double area = (corners[1] - corners[0]).norm() * (corners[2] - corners[1]).norm();
    EXPECT_NEAR(area, cv::minAreaRect(pixel_corners).size.area(), 0.01);
  }
}

TEST(OrientedBox, NeverLeavesTheImageAndFitsAtLeastAsWellAsTheUprightBox) {
  cv::RNG random(7);
  for (int i = 0; i < 100; ++i) {
    cv::Mat mask = maskOf({});
    const cv::Point2f centre(random.uniform(0.F, 40.F), random.uniform(0.F, 30.F));
    cv::ellipse(mask, cv::RotatedRect(centre, cv::Size2f(25, 5), random.uniform(0.F, 180.F)), 255,
                cv::FILLED);
    if (cv::countNonZero(mask) == 0) continue;
    const auto corners = orientedBox(Mask(mask)).value();
    for (const Eigen::Vector2d& corner : corners) {
      EXPECT_TRUE(corner.x() >= 0.0 && corner.x() <= 40.0) << corner.x();
      EXPECT_TRUE(corner.y() >= 0.0 && corner.y() <= 30.0) << corner.y();
    }
    const double area = (corners[1] - corners[0]).norm() * (corners[2] - corners[1]).norm();
    EXPECT_GT(area, 0.0);
    EXPECT_LE(area, maskBounds(mask).area() + 1e-9);
  }
}

}  // namespace oriented_box_test
}  // namespace synthetic_dataset
