#include "render/shadows/map_depths.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace synthetic_dataset::render {
namespace map_depths_test {

constexpr int kSize = 40;

MapPiece piece(const cv::Rect& texels, double depth) {
  return {texels, cv::Mat(texels.size(), CV_32FC1, cv::Scalar(depth))};
}

/// The depths of a map, checked against the depths of its cells.
cv::Mat depthsOf(const MapDepths& map) {
  const MapDepths::Assembled assembled = map.assemble(true);
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column) {
      const float nearest =
          assembled.nearest().at<float>(row / MapDepths::kCell, column / MapDepths::kCell);
      EXPECT_LE(nearest, assembled.depths().at<float>(row, column));
    }
  }
  EXPECT_EQ(cv::sum(assembled.nearest() < 0.2F), cv::sum(assembled.depths() < 0.2F) / 16);
  return assembled.depths().clone();
}

/// With a camera that stands, further maps share what never moves (true); with one that drives,
/// each map has its own (false).
class MapDepthsTest : public testing::TestWithParam<bool> {
 protected:
  MapDepthsTest() {
    cv::randu(standing_, 0.5F, 1.0F);
    common_ = std::make_shared<MapDepths::Standing>(standing_.clone());
    if (GetParam()) common_->keep();
  }

  cv::Mat standing_ = cv::Mat(kSize, kSize, CV_32FC1);
  std::shared_ptr<MapDepths::Standing> common_;
};

TEST_P(MapDepthsTest, HasWhatMovesAlone) {
  const MapDepths one(common_, {piece({4, 8, 8, 8}, 0.1), piece({8, 12, 12, 4}, 0.15)});
  const MapDepths other(common_, {piece({20, 20, 16, 4}, 0.1)});
  for (int i = 0; i < 2; ++i) {  // in any order, any number of times
    cv::Mat wanted = standing_.clone();
    wanted(cv::Rect(8, 12, 12, 4)) = 0.15;
    wanted(cv::Rect(4, 8, 8, 8)) = 0.1;
    EXPECT_EQ(cv::norm(depthsOf(one), wanted, cv::NORM_INF), 0.0);
    wanted = standing_.clone();
    wanted(cv::Rect(20, 20, 16, 4)) = 0.1;
    EXPECT_EQ(cv::norm(depthsOf(other), wanted, cv::NORM_INF), 0.0);
    EXPECT_EQ(cv::norm(MapDepths(common_).assemble().depths(), standing_, cv::NORM_INF), 0.0);
  }
}

TEST_P(MapDepthsTest, KeepsWhatNeverMovesForFurtherMaps) {
  const MapDepths first(common_, {piece({4, 8, 8, 8}, 0.1)});
  EXPECT_GT(cv::norm(depthsOf(first), standing_, cv::NORM_INF), 0.0);
  common_->keep();
  EXPECT_EQ(cv::norm(common_->depths(), standing_, cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(depthsOf(first), standing_, cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(common_->depths(), standing_, cv::NORM_INF), 0.0);
}

TEST_P(MapDepthsTest, IsNearerOnlyWhereAPieceIs) {
  const MapDepths map(common_, {piece({0, 0, kSize, kSize}, 1.0)});
  EXPECT_EQ(cv::norm(map.assemble().depths(), standing_, cv::NORM_INF), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Cameras, MapDepthsTest, testing::Bool());

}  // namespace map_depths_test
}  // namespace synthetic_dataset::render
