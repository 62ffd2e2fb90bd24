#include "world/physics/mass_properties.h"

#include <gtest/gtest.h>

#include "world/physics/simple_models.h"

namespace synthetic_dataset::world {
namespace mass_properties_test {

Link heavyLink(double mass, const Eigen::Vector3d& centre_L, const Eigen::Vector3d& moments,
               const Pose& X_ML) {
  Link link = linkOf({}, X_ML);
  link.inertia = Inertia{mass, centre_L, moments.asDiagonal()};
  return link;
}

TEST(MassProperties, DumbbellFollowsTheParallelAxisTheorem) {
  // Two equal balls of 2 kg and moment 0.1 at x = -0.5 and x = 1.5: about their common centre,
  // moments across the bar gain 2 * 2 kg * (1 m)^2.
  Model model;
  model.links = {heavyLink(2.0, {0, 0, 0}, {0.1, 0.1, 0.1}, at(-0.5, 0, 3)),
                 heavyLink(2.0, {0.5, 0, 0}, {0.1, 0.1, 0.1}, at(1.0, 0, 3))};

  const MassProperties body = massOf(model);

  EXPECT_DOUBLE_EQ(body.mass, 4.0);
  EXPECT_TRUE(body.centre_F.isApprox(Eigen::Vector3d(0.5, 0, 3)));
  const Eigen::Matrix3d expected = Eigen::Vector3d(0.2, 4.2, 4.2).asDiagonal();
  EXPECT_TRUE(body.moments_F.isApprox(expected)) << body.moments_F;
}

TEST(MassProperties, TurnedLinkTurnsItsMoments) {
  Model model;
  model.links = {heavyLink(1.0, {1, 0, 0}, {1, 2, 3}, turnedAt({0, 0, 0}, M_PI / 2, {0, 0, 1}))};

  const MassProperties body = massOf(model);

  EXPECT_TRUE(body.centre_F.isApprox(Eigen::Vector3d(0, 1, 0)));
  const Eigen::Matrix3d expected = Eigen::Vector3d(2, 1, 3).asDiagonal();
  EXPECT_TRUE(body.moments_F.isApprox(expected)) << body.moments_F;
}

TEST(MassProperties, LinkWithoutInertiaIsItsCollisionsAtOneKilogram) {
  // A box 1 x 2 x 3: moments m/12 (b^2 + c^2).
  const Link link = linkOf({collisionOf(BoxShape{{1, 2, 3}}, at(0, 0, 1.5))});

  const MassProperties body = massOf(link);

  EXPECT_DOUBLE_EQ(body.mass, 1.0);
  EXPECT_TRUE(body.centre_F.isApprox(Eigen::Vector3d(0, 0, 1.5)));
  const Eigen::Matrix3d expected = Eigen::Vector3d(13.0 / 12, 10.0 / 12, 5.0 / 12).asDiagonal();
  EXPECT_TRUE(body.moments_F.isApprox(expected)) << body.moments_F;
}

TEST(MassProperties, TwoHalvesWeighAndTurnLikeTheWhole) {
  const Link whole = linkOf({collisionOf(BoxShape{{2, 1, 1}})});
  const Link halves = linkOf({collisionOf(BoxShape{{1, 1, 1}}, at(-0.5, 0, 0)),
                              collisionOf(BoxShape{{1, 1, 1}}, at(0.5, 0, 0))});

  EXPECT_TRUE(massOf(halves).moments_F.isApprox(massOf(whole).moments_F));
}

TEST(MassProperties, MeshIsTheSolidThatItEncloses) {
  const MassProperties mesh = solid(MeshShape{weldedBoxMesh({1, 2, 3})});
  const MassProperties box = solid(BoxShape{{1, 2, 3}});

  EXPECT_NEAR(mesh.mass, box.mass, 1e-2);
  EXPECT_TRUE(mesh.moments_F.isApprox(box.moments_F, 1e-3)) << mesh.moments_F;
}

TEST(MassProperties, RoundMeshNearsTheSphere) {
  const MassProperties mesh = solid(MeshShape{sphereMesh(0.5, 24)});
  const MassProperties sphere = solid(SphereShape{0.5});

  EXPECT_NEAR(mesh.mass / sphere.mass, 1.0, 0.02);
  EXPECT_NEAR(mesh.moments_F(0, 0) / sphere.moments_F(0, 0), 1.0, 0.03);
}

TEST(MassProperties, FlatMeshIsAPlate) {
  auto flat = std::make_shared<Mesh>(*weldedBoxMesh({2, 1, 0}));

  const MassProperties body = massOf(linkOf({collisionOf(MeshShape{flat})}));

  EXPECT_DOUBLE_EQ(body.mass, 1.0);
  EXPECT_NEAR(body.moments_F(2, 2), 5.0 / 12, 1e-6);
}

TEST(MassProperties, CylinderHasItsTextbookMoments) {
  const MassProperties body = massOf(linkOf({collisionOf(CylinderShape{0.3, 1.2})}));

  EXPECT_NEAR(body.moments_F(2, 2), 0.5 * 0.09, 1e-12);
  EXPECT_NEAR(body.moments_F(0, 0), (3 * 0.09 + 1.44) / 12, 1e-12);
}

}  // namespace mass_properties_test
}  // namespace synthetic_dataset::world
