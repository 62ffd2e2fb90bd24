#include "randomize/appearance/texture_tiling.h"

#include <gmock/gmock.h>

#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::randomize {
namespace texture_tiling_test {

TEST(MetresPerTexture, IsAPlanesSizeWhereItShowsItsTextureOnce) {
  const Eigen::Vector2d metres = metresPerTexture(*world::planeMesh({0, 0, 1}, {1000.0, 20.0}));
  EXPECT_NEAR(std::max(metres.x(), metres.y()), 1000.0, 1e-3);
  EXPECT_NEAR(std::min(metres.x(), metres.y()), 20.0, 1e-3);
}

TEST(MetresPerTexture, IsTheMeanOfABoxesFacesByTheirArea) {
  EXPECT_TRUE(metresPerTexture(*world::boxMesh({2, 2, 2})).isApprox(Eigen::Vector2d(2, 2), 1e-6));
}

TEST(MetresPerTexture, IsNothingWithoutTextureCoordinates) {
  world::Mesh mesh = *world::boxMesh({1, 1, 1});
  mesh.texture_coordinates.clear();
  EXPECT_TRUE(metresPerTexture(mesh).isZero());
}

}  // namespace texture_tiling_test
}  // namespace synthetic_dataset::randomize
