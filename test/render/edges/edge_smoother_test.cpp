/// Smooth edges, against pictures of the same scene with many more pixels.

#include "render/edges/edge_smoother.h"

#include <random>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "render/pixels/srgb.h"
#include "render/renderer.h"
#include "support/box_world.h"
#include "support/random_poses.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::render {
namespace edge_smoother_test {

using test::Stage;

constexpr int kTimes = 8;  // magnification along each side

const CameraModel kCamera(160, 120, {130.0, 130.0, 79.5, 59.5}, 0.1, 50.0);

/// The same image area in more pixels.
CameraModel magnified() {
  const Intrinsics& k = kCamera.intrinsics();
  const auto centre = [](double c) { return (c + 0.5) * kTimes - 0.5; };
  return {kCamera.width() * kTimes,
          kCamera.height() * kTimes,
          {k.fx * kTimes, k.fy * kTimes, centre(k.cx), centre(k.cy)},
          kCamera.near(),
          kCamera.far()};
}

cv::Mat linear(const cv::Mat& encoded) {
  cv::Mat light(encoded.size(), CV_32FC3);
  std::transform(encoded.begin<cv::Vec3b>(), encoded.end<cv::Vec3b>(), light.begin<cv::Vec3f>(),
                 [](const cv::Vec3b& pixel) {
                   const auto& table = render::linearFromSrgb();
                   return cv::Vec3f(table[pixel[0]], table[pixel[1]], table[pixel[2]]);
                 });
  return light;
}

/// A floor that passes below the camera, and what stands and moves on it.
class SmoothEdges : public testing::Test {
 protected:
  SmoothEdges() {
    description.ambient = {0.5F, 0.5F, 0.5F};
    description.background = {0.2F, 0.4F, 0.9F};
    world::Light sun;
    sun.direction_L = Eigen::Vector3d(0.4, 0.7, 0.6).normalized();
    description.lights = {sun};
    std::mt19937 random(11);
    const auto colour = [&] {
      std::uniform_real_distribution<float> share(0.1F, 0.9F);
      world::Material material;
      material.diffuse = {share(random), share(random), share(random), 1.0F};
      material.specular = {0.0F, 0.0F, 0.0F};
      return material;
    };
    stage.addBox({40, 0.2, 60}, makePose({0, 1.2, 0}, Eigen::Quaterniond::Identity()), -1,
                 colour());
    for (int i = 0; i < 12; ++i) {
      const Eigen::Vector3d place(0.7 * (i % 4) - 1.0, 0.6 * (i / 4) - 0.6, 3.0 + 0.3 * i);
      const Pose X_WL = makePose(place, test::randomOrientation(random));
      const int object = i % 3 - 1;  // the world's, or one of two objects
      if (i % 2 == 0) {
        stage.addBox({0.5, 0.3, 0.4}, X_WL, object, colour());
      } else {
        stage.addMesh(world::sphereMesh(0.25), X_WL, object, colour());
      }
    }
  }

  [[nodiscard]] cv::Mat draw(const CameraModel& camera, Sampling sampling) const {
    Renderer renderer(description, stage.links(), {});
    return renderer.colour({camera, Pose::Identity()}, stage.poses(),
                           {stage.all(), stage.all(), sampling});
  }

  world::Description description;
  Stage stage;
};

TEST_F(SmoothEdges, AreNearlyThoseOfManyMorePixels) {
  cv::Mat truth;
  cv::resize(linear(draw(magnified(), Sampling::kCentre)), truth,
             {kCamera.width(), kCamera.height()}, 0, 0, cv::INTER_AREA);

  const cv::Mat smooth = linear(draw(kCamera, Sampling::kSmooth));
  const cv::Mat centres = linear(draw(kCamera, Sampling::kCentre));

  const double of_centres = cv::norm(centres, truth, cv::NORM_L2);
  EXPECT_LT(cv::norm(smooth, truth, cv::NORM_L2), 0.4 * of_centres);
  // Four samples can miss an edge by a quarter of a pixel, and a corner by a little more.
  const cv::Mat off = cv::abs(smooth - truth);
  EXPECT_LT(cv::countNonZero(off.reshape(1) > 0.2), 30);
}

TEST_F(SmoothEdges, LeaveAllOtherPixelsAlone) {
  const cv::Mat smooth = draw(kCamera, Sampling::kSmooth);
  const cv::Mat centres = draw(kCamera, Sampling::kCentre);
  cv::Mat changed;
  cv::cvtColor(cv::abs(smooth - centres), changed, cv::COLOR_BGR2GRAY);
  EXPECT_GT(cv::countNonZero(changed), 500);
  EXPECT_LT(cv::countNonZero(changed), 4000) << "of 19200";

  Renderer renderer(description, stage.links(), {1});
  const cv::Mat one_sample =
      renderer.colour({kCamera, Pose::Identity()}, stage.poses(), {stage.all(), stage.all()});
  EXPECT_EQ(cv::norm(one_sample, centres, cv::NORM_INF), 0.0);
}

}  // namespace edge_smoother_test
}  // namespace synthetic_dataset::render
