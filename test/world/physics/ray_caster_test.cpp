#include "world/physics/ray_caster.h"

#include <gtest/gtest.h>

#include "world/physics/simple_models.h"

namespace synthetic_dataset::world {
namespace ray_caster_test {

Link visualLink(std::shared_ptr<const Mesh> mesh, const Pose& X_LV = Pose::Identity()) {
  Link link;
  link.visuals.resize(1);
  link.visuals[0].X_LV = X_LV;
  link.visuals[0].surfaces = {Surface{std::move(mesh), {}}};
  return link;
}

TEST(RayCaster, MeasuresTheDistanceToABox) {
  const Link box = visualLink(weldedBoxMesh({2, 2, 2}));
  const RayCaster caster({{&box, Role::kStatic, -1}}, {at(5, 0, 0)});

  const auto hit = caster.cast({0, 0.3, 0.4}, {10, 0, 0}, 100.0);

  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->link, 0U);
  EXPECT_NEAR(hit->distance, 4.0, 1e-9);
  EXPECT_TRUE(hit->normal_W.isApprox(Eigen::Vector3d(-1, 0, 0), 1e-9));
}

TEST(RayCaster, MeasuresASlantedRay) {
  // Into the turned box's top, which is the plane z = 1, from 3 m above it at 60 degrees.
  const Link box = visualLink(weldedBoxMesh({8, 8, 2}));
  const RayCaster caster({{&box, Role::kStatic, -1}}, {turnedAt({0, 0, 0}, 0.3, {0, 0, 1})});

  const auto hit = caster.cast({0, 0, 4}, {std::sqrt(3.0), 0, -3.0}, 100.0);

  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance, 3.0 / std::cos(M_PI / 6), 1e-6);
  EXPECT_TRUE(hit->normal_W.isApprox(Eigen::Vector3d(0, 0, 1), 1e-6));
}

TEST(RayCaster, FollowsASphere) {
  const Link ball = visualLink(sphereMesh(1.0, 90));
  const RayCaster caster({{&ball, Role::kStatic, -1}}, {at(0, 0, 4)});

  for (double offset = -0.9; offset < 0.95; offset += 0.1) {
    const auto hit = caster.cast({offset, 0.01, 0}, {0, 0, 1}, 100.0);
    ASSERT_TRUE(hit) << offset;
    EXPECT_NEAR(hit->distance, 4.0 - std::sqrt(1.0 - offset * offset - 1e-4), 2e-3) << offset;
  }
  EXPECT_FALSE(caster.cast({1.01, 0, 0}, {0, 0, 1}, 100.0));
}

TEST(RayCaster, SeesJustPastAnEdge) {
  // A hundredth of a millimetre beside a box of 8 m, in front of another box.
  const Link box = visualLink(weldedBoxMesh({8, 8, 8}));
  const std::vector<LinkInstance> links(2, {&box, Role::kStatic, -1});
  const RayCaster caster(links, {at(10, 0, 0), at(20, 0, 1)});

  EXPECT_EQ(caster.cast({0, 0.3, 4 - 1e-5}, {1, 0, 0}, 100.0)->link, 0U);
  EXPECT_EQ(caster.cast({0, 0.3, 4 + 1e-5}, {1, 0, 0}, 100.0)->link, 1U);
}

TEST(RayCaster, FindsNoGapBetweenTriangles) {
  const Link ball = visualLink(sphereMesh(1.0, 24));
  const RayCaster caster({{&ball, Role::kStatic, -1}}, {turnedAt({0, 0, 0}, 0.7, {1, 2, 3})});

  for (const Surface& surface : ball.visuals[0].surfaces) {
    for (std::size_t i = 1; i < surface.mesh->positions.size(); ++i) {
      const Eigen::Vector3d middle = 0.5 * (surface.mesh->positions[i - 1].cast<double>() +
                                            surface.mesh->positions[i].cast<double>());
      const Eigen::Vector3d target = turnedAt({0, 0, 0}, 0.7, {1, 2, 3}) * middle;
      EXPECT_TRUE(caster.cast(Eigen::Vector3d::Zero(), target, 100.0)) << i;
    }
  }
}

TEST(RayCaster, NamesTheNearestLink) {
  const Link box = visualLink(weldedBoxMesh({1, 1, 1}));
  const std::vector<LinkInstance> links(3, {&box, Role::kStatic, -1});
  const RayCaster caster(links, {at(9, 0, 0), at(3, 0, 0), at(6, 0, 0)});

  EXPECT_EQ(caster.cast({0, 0, 0}, {1, 0, 0}, 100.0)->link, 1U);
  EXPECT_EQ(caster.cast({12, 0, 0}, {-1, 0, 0}, 100.0)->link, 0U);
}

TEST(RayCaster, PlacesVisualsInTheirLinks) {
  const Link box = visualLink(weldedBoxMesh({1, 1, 1}), at(0, 0, 2));
  const RayCaster caster({{&box, Role::kStatic, -1}},
                         {turnedAt({5, 0, 0}, M_PI / 2, {1, 0, 0})});  // link z to world -y

  EXPECT_FALSE(caster.cast({0, 0, 2}, {1, 0, 0}, 100.0));
  EXPECT_NEAR(caster.cast({0, -2, 0}, {1, 0, 0}, 100.0)->distance, 4.5, 1e-9);
}

TEST(RayCaster, FollowsTheLinkPoses) {
  const Link box = visualLink(weldedBoxMesh({1, 1, 1}));
  RayCaster caster({{&box, Role::kStatic, -1}}, {at(5, 0, 0)});

  caster.setLinkPoses({at(0, 7, 0)});

  EXPECT_FALSE(caster.cast({0, 0, 0}, {1, 0, 0}, 100.0));
  EXPECT_NEAR(caster.cast({0, 0, 0}, {0, 1, 0}, 100.0)->distance, 6.5, 1e-9);
}

TEST(RayCaster, SeesNothingBeyondItsRange) {
  const Link box = visualLink(weldedBoxMesh({1, 1, 1}));
  const RayCaster caster({{&box, Role::kStatic, -1}}, {at(5, 0, 0)});

  EXPECT_FALSE(caster.cast({0, 0, 0}, {1, 0, 0}, 4.4));
  EXPECT_TRUE(caster.cast({0, 0, 0}, {1, 0, 0}, 4.6));
}

TEST(RayCaster, HitsTrianglesFromBehind) {
  const Link box = visualLink(weldedBoxMesh({2, 2, 2}));
  const RayCaster caster({{&box, Role::kStatic, -1}}, {at(0, 0, 0)});

  const auto hit = caster.cast({0.1, 0.2, 0}, {0, 0, 1}, 100.0);

  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance, 1.0, 1e-9);
  EXPECT_TRUE(hit->normal_W.isApprox(Eigen::Vector3d(0, 0, -1), 1e-9));
}

TEST(RayCaster, SkipsLinksWithoutTriangles) {
  const Link empty = visualLink(std::make_shared<Mesh>());
  const Link box = visualLink(weldedBoxMesh({1, 1, 1}));
  const RayCaster caster({{&empty, Role::kStatic, -1}, {&box, Role::kObject, 0}},
                         {at(2, 0, 0), at(4, 0, 0)});

  EXPECT_EQ(caster.cast({0, 0, 0}, {1, 0, 0}, 100.0)->link, 1U);
}

}  // namespace ray_caster_test
}  // namespace synthetic_dataset::world
