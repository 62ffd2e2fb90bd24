#include "label/instance_map.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

namespace synthetic_dataset::label {
namespace instance_map_test {

using ::testing::Optional;

cv::Mat idsOf(const std::vector<std::vector<int>>& rows) {
  cv::Mat ids(static_cast<int>(rows.size()), static_cast<int>(rows[0].size()), CV_32SC1);
  for (int v = 0; v < ids.rows; ++v) {
    for (int u = 0; u < ids.cols; ++u) {
      ids.at<int>(v, u) = rows[static_cast<std::size_t>(v)][static_cast<std::size_t>(u)];
    }
  }
  return ids;
}

std::vector<int> rowOf(const cv::Mat& map, int row) {
  cv::Mat numbers;
  map.row(row).convertTo(numbers, CV_32SC1);
  return numbers;
}

Mask maskOf(const cv::Mat& ids, int id) { return Mask(ids == id); }

TEST(InstanceMap, KeepsIdentifiersPast255) {
  EXPECT_EQ(rowOf(instanceMap(idsOf({{0, 255, 256, 65535}})), 0),
            (std::vector<int>{0, 255, 256, 65535}));
}

TEST(InstancePixels, CountsAndBoundsEachObject) {
  const auto pixels = instancePixels(instanceMap(idsOf({{0, 1, 1, 0}, {3, 0, 1, 3}})), 3);
  EXPECT_EQ(pixels[0].count, 3);
  EXPECT_EQ(pixels[0].bounds, cv::Rect(1, 0, 2, 2));
  EXPECT_EQ(pixels[1].count, 0);
  EXPECT_EQ(pixels[2].bounds, cv::Rect(0, 1, 4, 1));
}

TEST(InstanceMask, IsOneObjectsPart) {
  const cv::Mat map = instanceMap(idsOf({{2, 1, 2}}));
  EXPECT_EQ(rowOf(instanceMask(map, 2, {0, 0, 3, 1}).whole(), 0), (std::vector<int>{255, 0, 255}));
  EXPECT_EQ(rowOf(instanceMask(map, 3, {}).whole(), 0), (std::vector<int>{0, 0, 0}));
}

TEST(LayeredInstanceMap, GivesAPixelToTheObjectThatTheIdentifiersShow) {
  // Each mask was found with one object in view: they overlap where 1 stands before 2.
  const Mask first = maskOf(idsOf({{1, 1, 1, 0}}), 1);
  const Mask second = maskOf(idsOf({{0, 1, 1, 1}}), 1);
  const cv::Mat map = layeredInstanceMap({first, second}, idsOf({{1, 1, 1, 2}}), {5.0, 1.0});
  EXPECT_EQ(rowOf(map, 0), (std::vector<int>{1, 1, 1, 2}));
}

TEST(LayeredInstanceMap, GivesAnOutlineThatBothHaveToTheNearer) {
  const Mask both = maskOf(idsOf({{1}}), 1);
  EXPECT_EQ(rowOf(layeredInstanceMap({both, both}, idsOf({{0}}), {5.0, 1.0}), 0),
            (std::vector<int>{2}));
}

TEST(LayeredInstanceMap, LeavesAPixelThatSubtractionMissedToNobody) {
  const Mask missed(cv::Size(1, 1));
  EXPECT_EQ(rowOf(layeredInstanceMap({missed}, idsOf({{1}}), {1.0}), 0), (std::vector<int>{0}));
}

TEST(Renumbered, LeavesTheWorldAlone) {
  EXPECT_EQ(rowOf(renumbered(instanceMap(idsOf({{0, 1, 2}})), {7, 300}), 0),
            (std::vector<int>{0, 7, 300}));
}

TEST(IntersectionOverUnion, ComparesObjectByObject) {
  const cv::Mat found = instanceMap(idsOf({{1, 1, 0, 2}}));
  const cv::Mat exact = instanceMap(idsOf({{1, 1, 1, 0}}));
  const auto overlaps = intersectionOverUnion(found, exact, 2);
  EXPECT_THAT(overlaps[0], Optional(2.0 / 3.0));
  EXPECT_EQ(overlaps[1], std::nullopt);
}

}  // namespace instance_map_test
}  // namespace synthetic_dataset::label
