#include "plugins/shared/mask_outlines.h"

#include <opencv2/imgproc.hpp>

#include <gmock/gmock.h>

namespace synthetic_dataset {
namespace mask_outlines_test {

using testing::ElementsAre;
using testing::IsEmpty;

/// A mask drawn in rows: `#` is on.
cv::Mat1b drawn(const std::vector<std::string>& rows) {
  cv::Mat1b mask(static_cast<int>(rows.size()), static_cast<int>(rows.front().size()),
                 std::uint8_t{0});
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const char letter = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      mask(y, x) = letter == '#' ? 255 : 0;
    }
  }
  return mask;
}

/// Whether a place is inside a polygon by the rule of odd and even crossings of a ray to the left.
bool isInside(const masks::Ring& ring, double u, double v) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const cv::Point a = ring[i];
    const cv::Point b = ring[(i + 1) % ring.size()];
    if ((a.y > v) == (b.y > v)) continue;
    const double crossing = a.x + (v - a.y) * (b.x - a.x) / static_cast<double>(b.y - a.y);
    if (crossing < u) inside = !inside;
  }
  return inside;
}

/// The pixels whose centres are in one of the polygons, which span 0 to the image's width.
cv::Mat1b filled(const std::vector<masks::Ring>& rings, const cv::Size& size) {
  cv::Mat1b mask(size, std::uint8_t{0});
  for (const masks::Ring& ring : rings) {
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        if (isInside(ring, x + 0.5, y + 0.5)) mask(y, x) = 255;
      }
    }
  }
  return mask;
}

/// Fills the polygon as Ultralytics does with an instance's only one.
cv::Mat1b filledWithRim(const masks::Ring& ring, const cv::Size& size) {
  cv::Mat1b mask(size, std::uint8_t{0});
  if (!ring.empty()) cv::fillPoly(mask, std::vector<masks::Ring>{ring}, cv::Scalar(255));
  return mask;
}

int differentPixels(const cv::Mat& a, const cv::Mat& b) { return cv::countNonZero(a != b); }

/// Noise, at a density in per cent, from a fixed sequence.
cv::Mat1b noise(const cv::Size& size, std::uint64_t seed, int density) {
  cv::RNG random(seed);
  cv::Mat1b mask(size);
  for (std::uint8_t& pixel : mask) pixel = random.uniform(0, 100) < density ? 255 : 0;
  return mask;
}

const cv::Mat1b kRing = drawn({"......",  //
                               ".####.",  //
                               ".#..#.",  //
                               ".####."});

TEST(EdgeRings, GoRoundABlockAlongItsPixelsEdges) {
  const cv::Mat1b mask = drawn({".....", ".###.", ".###.", "....."});
  EXPECT_THAT(
      masks::edgeRings(Mask(mask)),
      ElementsAre(ElementsAre(cv::Point(1, 1), cv::Point(4, 1), cv::Point(4, 3), cv::Point(1, 3))));
}

TEST(EdgeRings, GoRoundASinglePixelInTheImagesCorner) {
  EXPECT_THAT(
      masks::edgeRings(Mask(drawn({"....", "...#"}))),
      ElementsAre(ElementsAre(cv::Point(3, 1), cv::Point(4, 1), cv::Point(4, 2), cv::Point(3, 2))));
}

TEST(EdgeRings, AreNoneOfAnEmptyMask) {
  EXPECT_THAT(masks::edgeRings(Mask(drawn({"...."}))), IsEmpty());
}

TEST(EdgeRings, CutAHoleByASeamStraightAboveIt) {
  // Down the seam from (2, 1), counterclockwise around the hole of 2 x 1 pixels, and up again. The
  // outline goes straight on past the seam's upper end.
  EXPECT_THAT(
      masks::edgeRings(Mask(kRing)),
      ElementsAre(ElementsAre(cv::Point(1, 1), cv::Point(2, 1), cv::Point(2, 3), cv::Point(4, 3),
                              cv::Point(4, 2), cv::Point(2, 2), cv::Point(2, 1), cv::Point(5, 1),
                              cv::Point(5, 4), cv::Point(1, 4))));
}

TEST(EdgeRings, ArePolygonsOfTheirOwnForParts) {
  EXPECT_EQ(masks::edgeRings(Mask(drawn({"##.#", "##.#"}))).size(), 2U);
}

TEST(EdgeRings, HoldPixelsTogetherThatShareACorner) {
  EXPECT_EQ(masks::edgeRings(Mask(drawn({"#...", ".#.."}))).size(), 1U);
}

TEST(EdgeRings, FilledAreTheMask) {
  for (const int density : {5, 30, 50, 70, 95, 100}) {
    const cv::Mat1b mask = noise({37, 29}, 7, density);
    EXPECT_EQ(differentPixels(filled(masks::edgeRings(Mask(mask)), mask.size()), mask), 0)
        << density << " per cent";
  }
}

TEST(EdgeRings, FindHolesInPartsInHoles) {
  cv::Mat1b mask(21, 21, std::uint8_t{0});
  for (int margin = 0; margin < 10; ++margin) {
    mask(cv::Rect(margin, margin, 21 - 2 * margin, 21 - 2 * margin)) = margin % 2 == 0 ? 255 : 0;
  }
  EXPECT_EQ(masks::edgeRings(Mask(mask)).size(), 5U);
  EXPECT_EQ(differentPixels(filled(masks::edgeRings(Mask(mask)), mask.size()), mask), 0);
}

TEST(CentreRing, GoesThroughTheCentresOfTheRim) {
  const cv::Mat1b mask = drawn({".....", ".###.", ".###.", ".###."});
  EXPECT_THAT(masks::centreRing(Mask(mask)),
              ElementsAre(cv::Point(1, 1), cv::Point(3, 1), cv::Point(3, 3), cv::Point(1, 3)));
}

TEST(CentreRing, HasThreePointsForOnePixel) {
  const cv::Point only(2, 1);
  EXPECT_THAT(masks::centreRing(Mask(drawn({"....", "..#."}))), ElementsAre(only, only, only));
}

TEST(CentreRing, HasThreePointsForALine) {
  EXPECT_THAT(masks::centreRing(Mask(drawn({".###"}))),
              ElementsAre(cv::Point(1, 0), cv::Point(3, 0), cv::Point(3, 0)));
}

TEST(CentreRing, IsEmptyForAnEmptyMask) {
  EXPECT_THAT(masks::centreRing(Mask(drawn({"...."}))), IsEmpty());
}

TEST(CentreRing, FilledWithItsRimIsAMaskWithHoles) {
  EXPECT_EQ(differentPixels(filledWithRim(masks::centreRing(Mask(kRing)), kRing.size()), kRing), 0);
}

TEST(CentreRing, JoinsPartsByTheShortestBridge) {
  const cv::Mat1b mask = drawn({"##....",  //
                                "##....",  //
                                "......",  //
                                "##..##"});
  // The bridges are one pixel down and two pixels to the right.
  const cv::Mat1b bridged = filledWithRim(masks::centreRing(Mask(mask)), mask.size());
  EXPECT_EQ(cv::countNonZero(bridged), cv::countNonZero(mask) + 1 + 2);
  EXPECT_EQ(cv::countNonZero(mask & ~bridged), 0);
}

TEST(CentreRing, JoinsAPartInAHole) {
  const cv::Mat1b mask = drawn({"#######",  //
                                "#.....#",  //
                                "#..#..#",  //
                                "#.....#",  //
                                "#######"});
  EXPECT_EQ(differentPixels(filledWithRim(masks::centreRing(Mask(mask)), mask.size()), mask), 1);
}

TEST(CentreRing, FilledIsTheMaskWhereItIsOnePart) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    cv::Mat1b mask = noise({41, 33}, seed, 70);
    mask(16, 20) = 255;
    cv::Mat1i parts;
    cv::connectedComponents(mask, parts, 8, CV_32S);
    mask.setTo(0, parts != parts(16, 20));
    ASSERT_GT(cv::countNonZero(mask), 500);
    EXPECT_EQ(differentPixels(filledWithRim(masks::centreRing(Mask(mask)), mask.size()), mask), 0)
        << "seed " << seed;
  }
}

TEST(CentreRing, FilledHoldsAllOfANoisyMask) {
  for (const int density : {2, 10, 30, 60}) {
    const cv::Mat1b mask = noise({64, 48}, 11, density);
    const cv::Mat1b bridged = filledWithRim(masks::centreRing(Mask(mask)), mask.size());
    EXPECT_EQ(cv::countNonZero(mask & ~bridged), 0) << density << " per cent";
  }
}

}  // namespace mask_outlines_test
}  // namespace synthetic_dataset
