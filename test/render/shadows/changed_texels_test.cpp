#include "render/shadows/changed_texels.h"

#include <gtest/gtest.h>

namespace synthetic_dataset::render {
namespace changed_texels_test {

constexpr int kSize = 64;
const cv::Size kNoReach(0, 0);

cv::Mat map(float depth) { return {kSize, kSize, CV_32FC1, cv::Scalar(depth)}; }

/// Whether a texel's cell is marked.
bool isMarked(const ChangedTexels& changed, int column, int row) {
  const cv::Point cell(column / ChangedTexels::kCell, row / ChangedTexels::kCell);
  return changed.place.contains(cell) &&
         changed.cells.at<unsigned char>(cell - changed.place.tl()) != 0;
}

TEST(ChangedTexels, AreWhereSomethingIsNearerThanWhatStands) {
  cv::Mat standing = map(0.5F);
  // A piece that does not begin or end at a cell's border; one of its texels is nearer than what
  // stands.
  MapPiece piece{{5, 9, 22, 13}, cv::Mat(13, 22, CV_32FC1, cv::Scalar(0.7))};
  for (const cv::Point& nearer : {cv::Point(0, 0), cv::Point(21, 12), cv::Point(10, 6)}) {
    cv::Mat depths = piece.depths.clone();
    depths.at<float>(nearer) = 0.3F;
    const ChangedTexels changed =
        changedBy({{piece.texels, depths}}, standing, kNoReach, Eigen::Matrix4d::Identity());
    const cv::Point there = piece.texels.tl() + nearer;
    EXPECT_EQ(cv::countNonZero(changed.cells), 1) << nearer;
    EXPECT_TRUE(isMarked(changed, there.x, there.y)) << nearer;
  }
}

TEST(ChangedTexels, AreGrownByTheReachBeyondTheMap) {
  MapPiece piece{{0, 0, 4, 4}, cv::Mat(4, 4, CV_32FC1, cv::Scalar(0.1))};
  const ChangedTexels changed = changedBy({piece}, map(0.5F), {8, 4}, Eigen::Matrix4d::Identity());
  EXPECT_EQ(changed.place, cv::Rect(-2, -1, 5, 3));
  EXPECT_EQ(cv::countNonZero(changed.cells), 5 * 3);
}

TEST(ChangedTexels, OfSeveralPiecesAreThoseOfEach) {
  const cv::Mat near(4, 4, CV_32FC1, cv::Scalar(0.1));
  const ChangedTexels changed = changedBy({{{0, 0, 4, 4}, near}, {{40, 20, 4, 4}, near}}, map(0.5F),
                                          kNoReach, Eigen::Matrix4d::Identity());
  EXPECT_EQ(cv::countNonZero(changed.cells), 2);
  EXPECT_TRUE(isMarked(changed, 1, 1));
  EXPECT_TRUE(isMarked(changed, 41, 21));
}

TEST(ChangedTexels, AreAllOfThemWhereNothingIsKnown) {
  const ChangedTexels changed =
      allChanged({0, 0, kSize, kSize}, {3, 3}, Eigen::Matrix4d::Identity());
  EXPECT_EQ(changed.place, cv::Rect(-1, -1, kSize / 4 + 2, kSize / 4 + 2));
  EXPECT_EQ(cv::countNonZero(changed.cells), changed.place.area());
}

}  // namespace changed_texels_test
}  // namespace synthetic_dataset::render
