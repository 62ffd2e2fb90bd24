#include "plugins/readback/mask_shapes.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include "plugins/shared/mask_outlines.h"
#include "support/error_messages.h"

namespace synthetic_dataset::formats {
namespace mask_shapes_test {

using testing::ElementsAre;
using testing::HasSubstr;

/// Two parts, one of them with a hole.
cv::Mat twoParts() {
  cv::Mat image = cv::Mat::zeros(60, 80, CV_8UC1);
  image(cv::Rect(5, 5, 20, 30)).setTo(255);
  image(cv::Rect(10, 12, 6, 9)).setTo(0);
  image(cv::Rect(50, 40, 12, 7)).setTo(255);
  return image;
}

nlohmann::json edgesOf(const cv::Mat& image) {
  nlohmann::json polygons = nlohmann::json::array();
  for (const masks::Ring& ring : masks::edgeRings(Mask(image))) {
    polygons.push_back(nlohmann::json::array());
    for (const cv::Point& corner : ring) {
      polygons.back().push_back(corner.x);
      polygons.back().push_back(corner.y);
    }
  }
  return polygons;
}

TEST(MaskOfEdges, IsTheMaskThatPolygonsAlongItsPixelsEnclose) {
  EXPECT_EQ(cv::countNonZero(maskOfEdges(edgesOf(twoParts()), {80, 60}) != twoParts()), 0);
}

TEST(MaskOfEdges, TakesNoCornerThatIsMoved) {
  const nlohmann::json right = edgesOf(twoParts());
  for (std::size_t part = 0; part < right.size(); ++part) {
    for (std::size_t i = 0; i < right[part].size(); ++i) {
      nlohmann::json polygons = right;
      polygons[part][i] = right[part][i].get<int>() + 1;
      std::vector<std::string> messages = test::messagesOf([&] {
        const cv::Mat found = maskOfEdges(polygons, {80, 60});
        EXPECT_GT(cv::countNonZero(found != twoParts()), 0) << part << " " << i;
      });
      if (!messages.empty()) {
        EXPECT_THAT(messages, ElementsAre(HasSubstr("slanted edge")));
      }
    }
  }
}

TEST(OutlineOfCentres, MayHaveBridgesBetweenParts) {
  const Mask mask(twoParts());
  EXPECT_EQ(outlineProblem(masks::centreRing(mask), mask), "");
}

TEST(OutlineOfCentres, LacksNoPixelAndHasNoOther) {
  const Mask mask(twoParts());
  masks::Ring outline = masks::centreRing(mask);
  outline.front() -= cv::Point(2, 2);
  EXPECT_THAT(outlineProblem(outline, mask), HasSubstr("that are not of the mask"));
  const masks::Ring corner = {{5, 5}, {6, 5}, {5, 6}};
  EXPECT_THAT(outlineProblem(corner, mask), HasSubstr("that lacks"));
}

}  // namespace mask_shapes_test
}  // namespace synthetic_dataset::formats
