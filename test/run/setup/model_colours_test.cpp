#include "run/setup/model_colours.h"

#include <memory>

#include <gmock/gmock.h>

#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::run {
namespace model_colours_test {

using ::testing::IsEmpty;
using ::testing::SizeIs;

world::Model painted(const world::Material& material) {
  world::Visual visual;
  visual.surfaces.push_back({world::boxMesh({1, 1, 1}), material});
  world::Link link;
  link.visuals.push_back(visual);
  world::Model model;
  model.links.push_back(link);
  return model;
}

TEST(StrikingColours, AreThoseOfATextureNotItsGreys) {
  auto texture = std::make_shared<world::Texture>();
  texture->pixels = cv::Mat(100, 100, CV_8UC4, cv::Scalar(250, 250, 250, 255));
  texture->pixels.rowRange(0, 40).setTo(cv::Scalar(20, 100, 240, 255));  // orange
  texture->pixels.rowRange(40, 60).setTo(cv::Scalar(200, 60, 20, 255));  // blue
  texture->pixels.rowRange(60, 70).setTo(cv::Scalar(30, 30, 30, 255));
  world::Material material;
  material.texture = texture;
  const auto colours = strikingColours(painted(material));
  ASSERT_THAT(colours, SizeIs(2));
  EXPECT_TRUE(colours[0].isApprox(Eigen::Vector3d(240, 100, 20) / 255.0, 1e-6));
  EXPECT_TRUE(colours[1].isApprox(Eigen::Vector3d(20, 60, 200) / 255.0, 1e-6));
}

TEST(StrikingColours, AreNoneOfAGreyThing) {
  world::Material material;
  material.diffuse = {0.5F, 0.52F, 0.5F, 1.0F};
  EXPECT_THAT(strikingColours(painted(material)), IsEmpty());
  EXPECT_THAT(strikingColours(world::Model()), IsEmpty());
}

}  // namespace model_colours_test
}  // namespace synthetic_dataset::run
