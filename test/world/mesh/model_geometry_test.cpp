#include "world/mesh/model_geometry.h"

#include <random>

#include <gtest/gtest.h>

#include "world/physics/simple_models.h"

namespace synthetic_dataset::world {
namespace model_geometry_test {

Visual visualOf(std::shared_ptr<const Mesh> mesh, const Pose& X_LV = Pose::Identity()) {
  Visual visual;
  visual.X_LV = X_LV;
  visual.surfaces.push_back({std::move(mesh), {}});
  return visual;
}

/// A round link, a link of two boxes, and one without visuals.
std::vector<Link> someLinks() {
  std::vector<Link> links(3);
  links[0].visuals = {visualOf(sphereMesh(0.4, 40))};
  links[1].visuals = {visualOf(weldedBoxMesh({0.2, 0.3, 0.4}), turnedAt({1, 0, 0}, 0.4, {1, 2, 3})),
                      visualOf(weldedBoxMesh({0.5, 0.1, 0.1}))};
  return links;
}

std::vector<const Link*> pointersTo(const std::vector<Link>& links) {
  std::vector<const Link*> pointers;
  for (const Link& link : links) pointers.push_back(&link);
  return pointers;
}

TEST(ModelGeometry, BoxTouchesEveryOutermostVertexAtAnyPose) {
  const std::vector<Link> links = someLinks();
  const ModelGeometry geometry(pointersTo(links));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-2.0, 2.0);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Pose> X_OL;
    for (std::size_t i = 0; i < links.size(); ++i) {
      X_OL.push_back(turnedAt({number(random), number(random), number(random)}, number(random),
                              {number(random), number(random), number(random)}));
    }
    Eigen::Vector3d lowest = Eigen::Vector3d::Constant(1e9);
    Eigen::Vector3d highest = -lowest;
    for (std::size_t i = 0; i < links.size(); ++i) {
      for (const Visual& visual : links[i].visuals) {
        for (const Eigen::Vector3f& p_V : visual.surfaces[0].mesh->positions) {
          const Eigen::Vector3d p_O = X_OL[i] * (visual.X_LV * p_V.cast<double>());
          lowest = lowest.cwiseMin(p_O);
          highest = highest.cwiseMax(p_O);
        }
      }
    }

    const std::vector<Eigen::Vector3d> corners = geometry.box(X_OL);

    ASSERT_EQ(corners.size(), 8U);
    EXPECT_LT((corners.front() - lowest).norm(), 1e-12);
    EXPECT_LT((corners.back() - highest).norm(), 1e-12);
  }
}

TEST(ModelGeometry, IsEmptyWithoutVisuals) {
  const std::vector<Link> links(2);
  EXPECT_TRUE(ModelGeometry(pointersTo(links)).isEmpty());
  const std::vector<Link> visible = someLinks();
  EXPECT_FALSE(ModelGeometry(pointersTo(visible)).isEmpty());
}

}  // namespace model_geometry_test
}  // namespace synthetic_dataset::world
