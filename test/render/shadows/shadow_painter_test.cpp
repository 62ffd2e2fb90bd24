#include "render/shadows/shadow_painter.h"

#include <random>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/renderer.h"
#include "support/box_world.h"
#include "support/random_poses.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::render {
namespace shadow_painter_test {

using Meshes = std::vector<std::shared_ptr<const world::Mesh>>;

/// The mesh with a speck in its middle, whose border keeps the mesh from being a closed surface.
std::shared_ptr<const world::Mesh> withSpeck(const world::Mesh& mesh) {
  auto result = std::make_shared<world::Mesh>(mesh);
  const auto first = static_cast<std::uint32_t>(result->positions.size());
  for (const double x : {0.0, 1e-3, 2e-3}) {
    result->positions.emplace_back(static_cast<float>(x), static_cast<float>(x * x * 100), 0.0F);
    result->normals.emplace_back(0.0F, 0.0F, 1.0F);
  }
  result->texture_coordinates.resize(result->positions.size(), {0.0F, 0.0F});
  result->indices.insert(result->indices.end(), {first, first + 1, first + 2});
  return result;
}

/// Pictures from above of bodies that float over a floor in sunlight, each time elsewhere.
std::vector<cv::Mat> picturesOf(const Meshes& meshes, std::size_t count) {
  world::Description description;
  description.simulator = world::Simulator::kGz;
  description.ambient = {0.3F, 0.3F, 0.3F};
  world::Light sun;
  sun.casts_shadow = true;
  std::vector<cv::Mat> pictures;
  for (std::size_t i = 0; i < count; ++i) {
    std::mt19937 random(static_cast<unsigned>(i));
    sun.direction_L = test::randomPoint(random, 1.0);
    sun.direction_L.z() = -1.5;
    sun.direction_L.normalize();
    description.lights = {sun};
    test::Stage stage;
    stage.addBox({20, 20, 0.1}, makePose({0, 0, -1.5}, Eigen::Quaterniond::Identity()));
    int object = 0;
    for (const auto& mesh : meshes) {
      stage.addMesh(mesh, makePose(test::randomPoint(random, 1.0), test::randomOrientation(random)),
                    object++, {});
    }
    const View view{CameraModel(320, 240, {200.0, 200.0, 159.5, 119.5}, 0.05, 100.0),
                    makePose({0, 0, 5}, Eigen::Quaterniond(0, 1, 0, 0))};
    Renderer renderer(description, stage.links(), {});
    pictures.push_back(renderer.colour(view, stage.poses(), {stage.all(), stage.all()}));
  }
  return pictures;
}

TEST(CastShadows, OfBodiesAreNoOthersWithoutTheBacksOfTheirTriangles) {
  const Meshes bodies = {world::sphereMesh(0.3), world::boxMesh({0.2, 0.4, 0.8}),
                         world::capsuleMesh(0.1, 0.7), world::cylinderMesh(0.2, 0.3)};
  Meshes others;
  for (const auto& body : bodies) others.push_back(withSpeck(*body));
  constexpr std::size_t kPictures = 8;
  const std::vector<cv::Mat> pictures = picturesOf(bodies, kPictures);
  const std::vector<cv::Mat> wanted = picturesOf(others, kPictures);
  for (std::size_t i = 0; i < kPictures; ++i) {
    EXPECT_EQ(cv::norm(pictures[i], wanted[i], cv::NORM_INF), 0.0) << "picture " << i;
  }
}

/// The camera, too, is in the body, whose faces it does not see from within.
TEST(CastShadows, OfABodyFallOnWhatIsInIt) {
  world::Description description;
  description.simulator = world::Simulator::kGz;
  description.ambient = {0.3F, 0.3F, 0.3F};
  world::Light sun;
  sun.casts_shadow = true;
  sun.direction_L = Eigen::Vector3d(0.1, 0.2, -1.0).normalized();
  description.lights = {sun};
  const View view{CameraModel(64, 64, {60.0, 60.0, 31.5, 31.5}, 0.05, 100.0),
                  makePose({0, 0, 0.4}, Eigen::Quaterniond(0, 1, 0, 0))};  // downwards
  std::vector<double> brightness;
  for (const bool is_covered : {true, false}) {
    test::Stage stage;
    stage.addBox({20, 20, 0.1}, makePose({0, 0, -3}, Eigen::Quaterniond::Identity()));
    stage.addMesh(world::planeMesh(Eigen::Vector3d::UnitZ(), {0.5, 0.5}), Pose::Identity(), 0, {});
    if (is_covered) stage.addMesh(world::boxMesh({1, 1, 1}), Pose::Identity(), 1, {});
    Renderer renderer(description, stage.links(), {});
    const cv::Mat picture =
        renderer.colour(view, stage.poses(), {stage.all(), stage.all(), Sampling::kCentre});
    brightness.push_back(picture.at<cv::Vec3b>(32, 32)[1]);
  }
  EXPECT_LT(brightness[0], 0.8 * brightness[1]);
}

TEST(CastShadows, OfALeafFallWhicheverSideIsLit) {
  for (const double side : {1.0, -1.0}) {
    const Meshes leaf = {world::planeMesh({0, 0, side}, {1, 1})};
    const Meshes nothing = {world::planeMesh({0, 0, side}, {1e-3, 1e-3})};
    const std::vector<cv::Mat> pictures = picturesOf(leaf, 3);
    const std::vector<cv::Mat> empty = picturesOf(nothing, 3);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      cv::Mat darker;
      cv::subtract(empty[i], pictures[i], darker);
      EXPECT_GT(cv::countNonZero(darker.reshape(1) > 40), 300) << "side " << side << ", " << i;
    }
  }
}

}  // namespace shadow_painter_test
}  // namespace synthetic_dataset::render
