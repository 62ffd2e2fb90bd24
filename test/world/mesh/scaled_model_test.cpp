#include "world/mesh/scaled_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "world/physics/simple_models.h"

namespace synthetic_dataset::world {
namespace scaled_model_test {

template <class Wanted>
const Wanted& shapeOf(const Model& model, std::size_t collision) {
  return std::get<Wanted>(model.links.at(0).collisions.at(collision).shape);
}

/// A model with all kinds of parts, whose mesh belongs to two surfaces and a collision.
Model everything() {
  const auto mesh = weldedBoxMesh({1, 2, 3});
  Model model;
  model.links = {linkOf({collisionOf(BoxShape{{1, 2, 3}}, at(1, 0, 0)),
                         collisionOf(SphereShape{0.5}), collisionOf(CylinderShape{0.1, 2.0}),
                         collisionOf(MeshShape{mesh}), collisionOf(PlaneShape{{0, 0, 1}})},
                        turnedAt({0, 1, 2}, 0.7, {1, 2, 3}))};
  Visual visual;
  visual.X_LV = turnedAt({3, 0, 1}, 0.3, {0, 1, 1});
  visual.surfaces = {{mesh, {}}, {mesh, {}}};
  model.links[0].visuals = {visual};
  return model;
}

TEST(ScaledModel, HasAllLengthsTimesTheFactor) {
  const Model given = everything();
  const Model made = scaled(given, 3.0);
  const Link& link = made.links.at(0);
  EXPECT_TRUE(link.X_ML.translation().isApprox(Eigen::Vector3d(0, 3, 6)));
  EXPECT_TRUE(link.X_ML.linear() == given.links[0].X_ML.linear());
  EXPECT_TRUE(link.visuals[0].X_LV.translation().isApprox(Eigen::Vector3d(9, 0, 3)));
  EXPECT_TRUE(link.collisions[0].X_LC.translation().isApprox(Eigen::Vector3d(3, 0, 0)));
  EXPECT_TRUE(shapeOf<BoxShape>(made, 0).size.isApprox(Eigen::Vector3d(3, 6, 9)));
  EXPECT_DOUBLE_EQ(shapeOf<SphereShape>(made, 1).radius, 1.5);
  EXPECT_DOUBLE_EQ(shapeOf<CylinderShape>(made, 2).radius, 0.3);
  EXPECT_DOUBLE_EQ(shapeOf<CylinderShape>(made, 2).length, 6.0);
  const auto& positions = link.visuals[0].surfaces[0].mesh->positions;
  for (const Eigen::Vector3f& position : positions) {
    EXPECT_TRUE(position.cwiseAbs().isApprox(Eigen::Vector3f(1.5F, 3.0F, 4.5F)));
  }
}

TEST(ScaledModel, SharesWhatTheModelShares) {
  const Model given = everything();
  const Model made = scaled(given, 0.5);
  const std::vector<Surface>& surfaces = made.links[0].visuals[0].surfaces;
  EXPECT_NE(surfaces[0].mesh, given.links[0].visuals[0].surfaces[0].mesh);
  EXPECT_EQ(surfaces[0].mesh, surfaces[1].mesh);
  EXPECT_EQ(surfaces[0].mesh, shapeOf<MeshShape>(made, 3).mesh);
}

/// Compared with a box of that size and density, with the inertia from textbooks.
TEST(ScaledModel, IsOfTheSameDensity) {
  const auto inertiaOfBox = [](const Eigen::Vector3d& size, double density) {
    Inertia inertia;
    inertia.mass = density * size.prod();
    const Eigen::Vector3d squares = size.cwiseAbs2();
    inertia.moments_L =
        (inertia.mass / 12.0 * (Eigen::Vector3d::Constant(squares.sum()) - squares)).asDiagonal();
    inertia.centre_of_mass_L = 0.25 * size;
    return inertia;
  };
  Model model = modelOf("box", BoxShape{{1, 2, 3}});
  model.links[0].inertia = inertiaOfBox({1, 2, 3}, 7.0);
  const Inertia made = *scaled(model, 1.5).links[0].inertia;
  const Inertia expected = inertiaOfBox({1.5, 3, 4.5}, 7.0);
  EXPECT_DOUBLE_EQ(made.mass, expected.mass);
  EXPECT_TRUE(made.moments_L.isApprox(expected.moments_L));
  EXPECT_TRUE(made.centre_of_mass_L.isApprox(expected.centre_of_mass_L));
}

}  // namespace scaled_model_test
}  // namespace synthetic_dataset::world
