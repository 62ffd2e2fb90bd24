#include "world/mesh/surface_points.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/error_messages.h"
#include "synthetic_dataset/errors.h"
#include "world/physics/simple_models.h"

namespace synthetic_dataset::world {
namespace surface_points_test {

Link linkWith(std::shared_ptr<const Mesh> mesh, const Pose& X_ML = Pose::Identity()) {
  Link link;
  link.X_ML = X_ML;
  Visual visual;
  visual.surfaces.push_back({std::move(mesh), {}});
  link.visuals.push_back(visual);
  return link;
}

double leastDistance(const std::vector<Eigen::Vector3d>& points) {
  double least = 1e9;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) least = std::min(least, (points[i] - points[k]).norm());
  }
  return least;
}

std::vector<Eigen::Vector3d> positions(const std::vector<SurfacePoint>& points,
                                       const std::vector<const Link*>& links) {
  std::vector<Eigen::Vector3d> result;
  for (const SurfacePoint& point : points) {
    result.push_back(links[point.link]->X_ML * point.p_L);
  }
  return result;
}

TEST(FarthestPoints, OfABoxBeginWithOppositeCorners) {
  const Link box = linkWith(weldedBoxMesh({1, 2, 3}));
  const auto points = positions(farthestPoints({&box}, 2), {&box});
  EXPECT_TRUE(points[0].cwiseAbs().isApprox(Eigen::Vector3d(0.5, 1, 1.5)));
  EXPECT_TRUE(points[1].isApprox(-points[0]));
}

TEST(FarthestPoints, LieOnTheSurfaceBetweenTheCornersToo) {
  const Link box = linkWith(weldedBoxMesh({1, 2, 3}), turnedAt({4, 5, 6}, 0.5, {1, 1, 0}));
  const auto points = farthestPoints({&box}, 30);
  int beside_corners = 0;
  for (const SurfacePoint& point : points) {
    const Eigen::Vector3d share = point.p_L.cwiseQuotient(Eigen::Vector3d(0.5, 1, 1.5)).cwiseAbs();
    EXPECT_NEAR(share.maxCoeff(), 1.0, 1e-6);
    if (share.minCoeff() < 0.99) ++beside_corners;
  }
  EXPECT_GE(beside_corners, 22);
  // Greedily chosen points are at worst half as far apart as the best choice (Gonzalez 1985); a
  // choice of 30 on this box (22 m^2) with squares of 0.8 m exists.
  EXPECT_GT(leastDistance(positions(points, {&box})), 0.4);
}

TEST(FarthestPoints, AreAsFarApartAsGreedyChoiceByBruteForce) {
  const Link ball = linkWith(sphereMesh(1.0, 12));
  const auto chosen = positions(farthestPoints({&ball}, 9), {&ball});
  // By brute force, among the vertices only.
  std::vector<Eigen::Vector3d> greedy;
  const auto& vertices = ball.visuals[0].surfaces[0].mesh->positions;
  greedy.push_back(vertices[0].cast<double>());
  while (greedy.size() < 9) {
    const auto distance = [&](const Eigen::Vector3f& p) {
      double least = 1e9;
      for (const auto& each : greedy) least = std::min(least, (p.cast<double>() - each).norm());
      return least;
    };
    greedy.push_back(
        std::max_element(vertices.begin(), vertices.end(), [&](const auto& a, const auto& b) {
          return distance(a) < distance(b);
        })->cast<double>());
  }
  EXPECT_GE(leastDistance(chosen), 0.5 * leastDistance(greedy));
}

TEST(FarthestPoints, CoverAllLinksAndKnowTheirs) {
  const Link left = linkWith(weldedBoxMesh({1, 1, 1}), at(-10, 0, 0));
  const Link right = linkWith(weldedBoxMesh({0.1, 0.1, 0.1}), at(10, 0, 0));
  const auto points = farthestPoints({&left, &right}, 2);
  EXPECT_NE(points[0].link, points[1].link);
}

TEST(FarthestPoints, AreTheSameEachTime) {
  const Link ball = linkWith(sphereMesh(0.3, 10));
  const auto one = positions(farthestPoints({&ball}, 20), {&ball});
  const auto two = positions(farthestPoints({&ball}, 20), {&ball});
  EXPECT_TRUE(one == two);
}

TEST(FarthestPoints, CannotBeMoreThanThereAre) {
  auto point = std::make_shared<Mesh>();
  point->positions = {{1, 2, 3}};
  point->indices = {0, 0, 0};
  const Link speck = linkWith(point);
  EXPECT_EQ(farthestPoints({&speck}, 1).size(), 1U);
  EXPECT_THAT(test::messagesOf([&] { static_cast<void>(farthestPoints({&speck}, 2)); }),
              testing::ElementsAre(testing::HasSubstr("only 1 different points")));
}

}  // namespace surface_points_test
}  // namespace synthetic_dataset::world
