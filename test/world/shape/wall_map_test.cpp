#include "world/shape/wall_map.h"

#include <opencv2/imgcodecs.hpp>

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {
namespace wall_map_test {

using synthetic_dataset::test::TemporaryFolder;
using testing::HasSubstr;
using testing::SizeIs;

constexpr std::size_t kBoxIndices = 36;

WallMap mapOf(const TemporaryFolder& folder, const cv::Mat_<uchar>& pixels) {
  WallMap map;
  map.file = folder / "map.png";
  cv::imwrite(map.file.string(), pixels);
  return map;
}

TEST(WallMap, MakesABoxOfADarkPixel) {
  const TemporaryFolder folder;
  WallMap map = mapOf(folder, cv::Mat_<uchar>({2, 3}, {255, 255, 255, 255, 255, 0}));
  map.scale = 0.5;
  map.height = 2.0;
  const auto mesh = wallMesh(map);
  Eigen::AlignedBox3f box;
  for (const auto& position : mesh->positions) box.extend(position);
  EXPECT_TRUE(box.min().isApprox(Eigen::Vector3f(1.0F, 0.5F, 0.0F)));
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector3f(1.5F, 1.0F, 2.0F)));
}

TEST(WallMap, CountsTheThresholdItselfAsWall) {
  const TemporaryFolder folder;
  const WallMap map = mapOf(folder, cv::Mat_<uchar>({1, 3}, {200, 201, 199}));
  EXPECT_THAT(wallMesh(map)->indices, SizeIs(2 * kBoxIndices));
}

TEST(WallMap, JoinsPixelsToFewBoxes) {
  const TemporaryFolder folder;
  const WallMap map = mapOf(
      folder, cv::Mat_<uchar>({4, 4}, {0, 0, 0, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 0, 0, 0}));
  EXPECT_THAT(wallMesh(map)->indices, SizeIs(4 * kBoxIndices));
}

TEST(WallMap, TakesBlocksOfSeveralPixels) {
  const TemporaryFolder folder;
  WallMap map = mapOf(folder, cv::Mat_<uchar>({2, 4}, {0, 255, 255, 255, 255, 255, 255, 255}));
  map.granularity = 4;
  Eigen::AlignedBox3f box;
  const auto mesh = wallMesh(map);
  for (const auto& position : mesh->positions) box.extend(position);
  EXPECT_TRUE(box.sizes().isApprox(Eigen::Vector3f(2.0F, 2.0F, 1.0F)));
}

TEST(WallMap, NamesAPictureWithoutWalls) {
  const TemporaryFolder folder;
  const WallMap map = mapOf(folder, cv::Mat_<uchar>({1, 1}, {255}));
  EXPECT_THAT(test::messagesOf([&] { static_cast<void>(wallMesh(map)); }),
              testing::ElementsAre(HasSubstr("map.png': makes 0 walls")));
}

}  // namespace wall_map_test
}  // namespace synthetic_dataset::world
