#include "run/pictures/model_portrait.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "support/box_world.h"

namespace synthetic_dataset::run {
namespace model_portrait_test {

const cv::Size kSize(256, 192);

/// A model of one red box, standing on the origin.
world::Description boxModel(const Eigen::Vector3d& size) {
  world::Material material;
  material.diffuse = {0.9F, 0.1F, 0.1F, 1.0F};
  world::Visual visual;
  visual.X_LV.translation().z() = 0.5 * size.z();
  visual.surfaces.push_back({test::boxMesh(size), material});
  world::Link link;
  link.visuals.push_back(visual);
  world::Model model;
  model.links.push_back(link);
  world::Description description;
  description.models.push_back(model);
  return description;
}

class Framing : public ::testing::TestWithParam<Eigen::Vector3d> {};

TEST_P(Framing, HoldsTheWholeModelAndFillsThePicture) {
  const Eigen::Vector3d size = GetParam();
  const Eigen::Vector3d corner(3.0, -7.0, 1.0);
  const render::View view = portraitView({corner, corner + size}, kSize);

  const Eigen::Vector2d middle(127.5, 95.5);
  double fullest = 0.0;
  for (const Eigen::Vector3d& p : test::boxCorners(size)) {
    const auto pixel = view.camera.project(view.X_WC.inverse() * (p + corner + 0.5 * size));
    ASSERT_TRUE(pixel);
    const Eigen::Vector2d offset = (*pixel - middle).cwiseAbs().cwiseQuotient(middle);
    fullest = std::max(fullest, offset.maxCoeff());
  }
  EXPECT_LT(fullest, 0.95);
  EXPECT_GT(fullest, 0.6);
}

INSTANTIATE_TEST_SUITE_P(Models, Framing,
                         ::testing::Values(Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(0.1, 0.1, 30),
                                           Eigen::Vector3d(100, 100, 0),
                                           Eigen::Vector3d(0.002, 0.001, 0.0005),
                                           Eigen::Vector3d(20, 0.1, 0.1),
                                           Eigen::Vector3d(800, 3000, 90)));

/// Pixels that are clearly red.
int redPixels(const cv::Mat& picture) {
  int count = 0;
  for (auto p = picture.begin<cv::Vec3b>(); p != picture.end<cv::Vec3b>(); ++p) {
    if ((*p)[2] > 2 * (*p)[0] && (*p)[2] > 60) ++count;
  }
  return count;
}

TEST(Portrait, ShowsTinyAndHugeModelsAlike) {
  const Eigen::Vector3d shape(1.0, 0.7, 0.8);
  const int usual = redPixels(portray(boxModel(shape), kSize));
  EXPECT_GT(usual, kSize.area() / 8);
  for (const double scale : {1e-3, 1e3}) {
    EXPECT_NEAR(redPixels(portray(boxModel(scale * shape), kSize)), usual, 0.02 * usual) << scale;
  }
}

TEST(Portrait, IsEmptyWhereThereIsNothingToSee) {
  world::Description description;
  description.models.resize(1);
  EXPECT_TRUE(portray(description, kSize).empty());
}

TEST(Portrait, CountsWhatThereIs) {
  world::Description description = boxModel({1, 1, 1});
  world::Visual& visual = description.models[0].links[0].visuals[0];
  visual.surfaces.push_back(visual.surfaces[0]);
  const auto texture = std::make_shared<world::Texture>();
  for (world::Surface& surface : visual.surfaces) surface.material.texture = texture;
  visual.surfaces[1].material.normal_map = std::make_shared<world::Texture>();

  const ModelCounts counts = countModels(description);

  EXPECT_EQ(counts.links, 1U);
  EXPECT_EQ(counts.visuals, 1U);
  EXPECT_EQ(counts.surfaces, 2U);
  EXPECT_EQ(counts.triangles, 24U);
  EXPECT_EQ(counts.textures, 2U) << "a shared one counts once";
}

}  // namespace model_portrait_test
}  // namespace synthetic_dataset::run
