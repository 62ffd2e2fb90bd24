#include "label/optical_flow.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>

#include "label/box_view.h"

namespace synthetic_dataset::label {
namespace optical_flow_test {

using test::BoxView;
using test::SeenBox;

const CameraModel kCamera(160, 120, {130.0, 131.0, 80.2, 59.6}, 0.05, 100.0);
const CameraModel kLens(160, 120, {105.1, 104.5, 80.4, 59.6}, 0.05, 100.0,
                        {DistortionModel::kPlumbBob, {-0.28, 0.09, 1e-3, -8e-4, -0.01}});
const CameraModel kFisheye(150, 150, {45.1, 45.2, 74.8, 75.1}, 0.05, 100.0,
                           {DistortionModel::kEquidistant, {-0.01, 0.003}, 1.6581});

Pose pose(const Eigen::Vector3d& p, const Eigen::Vector3d& axis = Eigen::Vector3d::UnitX(),
          double angle = 0.0) {
  return makePose(p, Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.normalized())));
}

/// Two boxes in front of the camera and a wall behind them; they and the camera all move.
struct MovingScene {
  std::vector<Pose> X_WL = {pose({-0.4, 0.1, 2.0}, {1, 2, 0}, 0.5),
                            pose({0.5, 0, 2.5}, {0, 1, 1}, 0.3), pose({0, 0, 4})};
  std::vector<Eigen::Vector3d> sizes = {{0.5, 0.4, 0.6}, {0.5, 0.5, 0.5}, {20, 20, 0.2}};
  Pose X_WC = pose({0.1, 0.05, -0.2}, {0, 1, 0}, 0.05);

  [[nodiscard]] BoxView look(const CameraModel& camera) const {
    std::vector<SeenBox> boxes;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      boxes.push_back({X_WC.inverse() * X_WL[i], sizes[i], 1});
    }
    return test::look(camera, boxes);
  }
};

/// Where OpenCV projects a point.
Eigen::Vector2d projected(const CameraModel& camera, const Eigen::Vector3d& p) {
  const Intrinsics& k = camera.intrinsics();
  const cv::Matx33d matrix(k.fx, 0, k.cx, 0, k.fy, k.cy, 0, 0, 1);
  const auto& d = camera.distortion().coefficients;
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(std::vector<cv::Point3d>{{p.x(), p.y(), p.z()}}, cv::Vec3d(), cv::Vec3d(),
                    matrix, cv::Vec<double, 5>(d[0], d[1], d[2], d[3], d[4]), pixels);
  return {pixels[0].x, pixels[0].y};
}

class OpticalFlow : public ::testing::TestWithParam<bool> {
 protected:
  const CameraModel& camera = GetParam() ? kLens : kCamera;
};

TEST_P(OpticalFlow, OfARollingShutterLeadsToTheRowThatHasThePointThen) {
  const MovingScene now;
  const BoxView seen = now.look(camera);
  const double height = camera.height();
  const render::RollingView rows{
      camera, {{-0.5, now.X_WC, now.X_WL}, {height - 0.5, now.X_WC, now.X_WL}}, 1};
  render::RollingView next{camera, {}, 4};
  for (int i = 0; i <= 4; ++i) {
    const double share = i / 4.0;
    std::vector<Pose> X_WL = now.X_WL;
    X_WL[0] = X_WL[0] * pose({0.2 * share, -0.1 * share, 0.02}, {1, 1, 0}, 0.3 * share);
    next.moments.push_back({share * height - 0.5,
                            now.X_WC * pose({0.05 * share, 0.01, 0}, {0, 1, 0.2}, 0.03 * share),
                            X_WL});
  }
  const cv::Mat flow = opticalFlow(rows, seen.range, seen.links, next);
  for (int v = 2; v < 120; v += 5) {
    for (int u = 2; u < 160; u += 5) {
      const auto link = static_cast<std::size_t>(seen.links.at<int>(v, u) - 1);
      const SeenBox box{now.X_WC.inverse() * now.X_WL[link], now.sizes[link], 1};
      const Eigen::Vector3d ray = *camera.ray({u, v});
      const Eigen::Vector3d p_L = box.X_CB.inverse() * (test::distanceTo(box, ray) * ray);
      const auto& step = flow.at<cv::Vec2f>(v, u);
      const Eigen::Vector2d to(u + static_cast<double>(step[0]), v + static_cast<double>(step[1]));
      const render::RollingMoment then = next.at(to.y());
      const Eigen::Vector2d there = projected(camera, then.X_WC.inverse() * then.X_WL[link] * p_L);
      EXPECT_LT((there - to).norm(), 5e-3) << u << ", " << v;
    }
  }
}

TEST_P(OpticalFlow, IsWhereProjectPointsPutsTheMovedPoints) {
  const MovingScene now;
  MovingScene next = now;
  next.X_WL[0] = next.X_WL[0] * pose({0.05, -0.03, 0.02}, {1, 1, 0}, 0.1);
  next.X_WL[1] = pose({0.6, 0.05, 2.3}, {0, 1, 1}, 0.4);
  next.X_WC = now.X_WC * pose({0.03, 0.01, 0.05}, {0, 1, 0.2}, 0.03);
  const BoxView seen = now.look(camera);

  const cv::Mat flow = opticalFlow(camera, seen.depth, seen.range, seen.links, now.X_WC, now.X_WL,
                                   camera, next.X_WC, next.X_WL);

  // The other way round: a point that is fixed in a box's frame is projected into both pictures.
  int compared = 0;
  for (int v = 2; v < 120; v += 5) {
    for (int u = 2; u < 160; u += 5) {
      const auto link = static_cast<std::size_t>(seen.links.at<int>(v, u) - 1);
      const SeenBox box{now.X_WC.inverse() * now.X_WL[link], now.sizes[link], 1};
      const Eigen::Vector3d ray = *camera.ray({u, v});
      const Eigen::Vector3d p_L = box.X_CB.inverse() * (test::distanceTo(box, ray) * ray);
      const Eigen::Vector2d first = projected(camera, now.X_WC.inverse() * now.X_WL[link] * p_L);
      const Eigen::Vector2d second = projected(camera, next.X_WC.inverse() * next.X_WL[link] * p_L);
      const auto& found = flow.at<cv::Vec2f>(v, u);
      EXPECT_NEAR(static_cast<double>(found[0]), (second - first).x(), 2e-3) << u << ", " << v;
      EXPECT_NEAR(static_cast<double>(found[1]), (second - first).y(), 2e-3) << u << ", " << v;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 24 * 32);
}

TEST_P(OpticalFlow, IsNothingWhereNothingMoves) {
  const MovingScene scene;
  const BoxView seen = scene.look(camera);

  const cv::Mat flow = opticalFlow(camera, seen.depth, seen.range, seen.links, scene.X_WC,
                                   scene.X_WL, camera, scene.X_WC, scene.X_WL);

  EXPECT_LT(cv::norm(flow, cv::NORM_INF), 1e-3);
}

TEST_P(OpticalFlow, IsTheSameFromDepthAlone) {
  const MovingScene now;
  MovingScene next = now;
  next.X_WL[0] = next.X_WL[0] * pose({0.05, -0.03, 0.02}, {1, 1, 0}, 0.1);
  const BoxView seen = now.look(camera);
  const auto flow = [&](const cv::Mat& range) {
    return opticalFlow(camera, seen.depth, range, seen.links, now.X_WC, now.X_WL, camera, next.X_WC,
                       next.X_WL);
  };

  EXPECT_LT(cv::norm(flow(seen.range), flow({}), cv::NORM_INF), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Lenses, OpticalFlow, ::testing::Bool(),
                         [](const auto& each) { return each.param ? "plumb_bob" : "pinhole"; });

TEST(OpticalFlowOfAMovingCamera, SpreadsFromWhereItGoes) {
  // Towards a wall 2 m ahead, by 0.5 m: all pixels move outwards by a third.
  const std::vector<Pose> X_WL = {pose({0, 0, 2.5})};
  const BoxView seen = test::look(kCamera, {{X_WL[0], {40, 40, 1}, 0}});

  const cv::Mat flow = opticalFlow(kCamera, seen.depth, seen.range, seen.links, Pose::Identity(),
                                   X_WL, kCamera, pose({0, 0, 0.5}), X_WL);

  for (const auto& [u, v] : {std::pair{0, 0}, {159, 0}, {100, 60}, {20, 110}}) {
    EXPECT_NEAR(static_cast<double>(flow.at<cv::Vec2f>(v, u)[0]), (u - 80.2) / 3, 1e-4);
    EXPECT_NEAR(static_cast<double>(flow.at<cv::Vec2f>(v, u)[1]), (v - 59.6) / 3, 1e-4);
  }
}

TEST(OpticalFlowOfAZoomingCamera, SpreadsAsItsFieldOfViewNarrows) {
  const CameraModel zoomed(160, 120, {195.0, 196.5, 80.2, 59.6}, 0.05, 100.0);  // f x 1.5
  const std::vector<Pose> X_WL = {pose({0, 0, 2.5})};
  const BoxView seen = test::look(kCamera, {{X_WL[0], {40, 40, 1}, 0}});

  const cv::Mat flow = opticalFlow(kCamera, seen.depth, seen.range, seen.links, Pose::Identity(),
                                   X_WL, zoomed, Pose::Identity(), X_WL);

  for (const auto& [u, v] : {std::pair{0, 0}, {159, 0}, {100, 60}, {20, 110}}) {
    EXPECT_NEAR(static_cast<double>(flow.at<cv::Vec2f>(v, u)[0]), (u - 80.2) / 2, 1e-4);
    EXPECT_NEAR(static_cast<double>(flow.at<cv::Vec2f>(v, u)[1]), (v - 59.6) / 2, 1e-4);
  }
}

TEST(OpticalFlowOfAFisheye, HoldsBesideAndBehindTheCamera) {
  // In a large box, a camera that turns about its own axis by one degree.
  constexpr double kTurn = 0.0174532925;
  const std::vector<Pose> X_WL = {Pose::Identity()};
  cv::Mat range(150, 150, CV_32FC1, cv::Scalar(3.0));
  cv::Mat depth = cv::Mat::zeros(150, 150, CV_32FC1);
  cv::Mat links(150, 150, CV_32SC1, cv::Scalar(1));

  const cv::Mat flow = opticalFlow(kFisheye, depth, range, links, Pose::Identity(), X_WL, kFisheye,
                                   pose({0, 0, 0}, {0, 0, 1}, kTurn), X_WL);

  int behind = 0;
  for (int v = 0; v < 150; ++v) {
    for (int u = 0; u < 150; ++u) {
      const auto ray = kFisheye.ray({u, v});
      const auto& found = flow.at<cv::Vec2f>(v, u);
      if (!ray) {
        EXPECT_TRUE(std::isnan(found[0])) << "the corners see nothing";
        continue;
      }
      if (ray->z() < 0.0) ++behind;
      if (std::isnan(found[0])) continue;  // by the rim
      // A turn about (cx, cy), opposite to the camera's; fx and fy differ a little.
      EXPECT_NEAR(static_cast<double>(found[0]), kTurn * (v - 75.1), 0.02);
      EXPECT_NEAR(static_cast<double>(found[1]), -kTurn * (u - 74.8), 0.02);
    }
  }
  EXPECT_GT(behind, 50);
}

TEST(OpticalFlowOfNothing, IsNoNumber) {
  const std::vector<Pose> X_WL = {pose({0, 0, 2})};
  const BoxView seen = test::look(kCamera, {{X_WL[0], {0.2, 0.2, 0.2}, 1}});
  const auto flow = [&](const Pose& X_WL_next) {
    return opticalFlow(kCamera, seen.depth, seen.range, seen.links, Pose::Identity(), X_WL, kCamera,
                       Pose::Identity(), {X_WL_next});
  };

  EXPECT_TRUE(std::isnan(flow(X_WL[0]).at<cv::Vec2f>(5, 5)[0])) << "nothing is seen";
  EXPECT_FALSE(std::isnan(flow(X_WL[0]).at<cv::Vec2f>(60, 80)[0]));
  EXPECT_TRUE(std::isnan(flow(pose({0, 0, -2})).at<cv::Vec2f>(60, 80)[1])) << "goes behind";
  EXPECT_NEAR(static_cast<double>(flow(pose({3.8, 0, 2})).at<cv::Vec2f>(60, 80)[0]), 130 * 2.0,
              1e-3)
      << "leaves the image";
}

}  // namespace optical_flow_test
}  // namespace synthetic_dataset::label
