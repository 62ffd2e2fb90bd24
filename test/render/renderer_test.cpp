#include "render/renderer.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <opencv2/imgproc.hpp>

#include "support/box_world.h"
#include "support/random_poses.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::render {
namespace renderer_test {

using test::Stage;

const CameraModel kCamera(640, 480, {554.38, 560.1, 321.7, 238.2}, 0.05, 100.0);

/// The optical frame at the origin of the world: +z ahead, x right, y down.
View viewFromOrigin(const CameraModel& camera = kCamera) { return {camera, Pose::Identity()}; }

Pose at(double x, double y, double z) {
  return makePose({x, y, z}, Eigen::Quaterniond::Identity());
}

world::Material coloured(float red, float green, float blue) {
  world::Material material;
  material.diffuse = {red, green, blue, 1.0F};
  material.specular = {0.0F, 0.0F, 0.0F};
  return material;
}

/// A world without lights, in which an ambient light of 1 gives everything its own colour.
world::Description unlit() {
  world::Description description;
  description.simulator = world::Simulator::kGz;
  description.ambient = {1.0F, 1.0F, 1.0F};
  description.background = {0.0F, 0.0F, 0.0F};
  return description;
}

/// The outline of a convex body as OpenCV projects it.
std::vector<cv::Point2f> projectedHull(const std::vector<Eigen::Vector3d>& points_C,
                                       const CameraModel& camera) {
  std::vector<cv::Point3d> points;
  for (const Eigen::Vector3d& p : points_C) points.emplace_back(p.x(), p.y(), p.z());
  const Intrinsics& k = camera.intrinsics();
  const cv::Matx33d matrix(k.fx, 0, k.cx, 0, k.fy, k.cy, 0, 0, 1);
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), matrix, cv::noArray(), pixels);
  const std::vector<cv::Point2f> rounded(pixels.begin(), pixels.end());
  std::vector<cv::Point2f> hull;
  cv::convexHull(rounded, hull);
  return hull;
}

/// How far the drawn edge strays from the true one [px]: the greatest distance from the outline of
/// a pixel centre that is drawn though outside, or not drawn though inside.
double edgeError(const cv::Mat& mask, const std::vector<cv::Point2f>& outline) {
  constexpr bool kSignedDistance = true;
  double worst = 0.0;
  for (int v = 0; v < mask.rows; ++v) {
    for (int u = 0; u < mask.cols; ++u) {
      const cv::Point2f centre(static_cast<float>(u), static_cast<float>(v));
      const bool drawn = mask.at<unsigned char>(v, u) != 0;
      const bool inside = cv::pointPolygonTest(outline, centre, !kSignedDistance) > 0;
      if (drawn == inside) continue;
      worst = std::max(worst, std::abs(cv::pointPolygonTest(outline, centre, kSignedDistance)));
    }
  }
  return worst;
}

TEST(Renderer, SilhouettesLieWhereProjectPointsSays) {
  const Eigen::Vector3d size(0.8, 0.5, 0.6);
  Stage stage;
  stage.addBox(size, Pose::Identity(), 0);
  Renderer renderer(unlit(), stage.links(), {});
  std::mt19937 random(1);
  constexpr int kPoses = 50;
  for (int i = 0; i < kPoses; ++i) {
    const Pose X_CO = makePose({0, 0, 2.2}, test::randomOrientation(random)) *
                      Eigen::Translation3d(test::randomPoint(random, 0.15));
    stage.poses()[0] = X_CO;
    std::vector<Eigen::Vector3d> corners;
    for (const Eigen::Vector3d& p : test::boxCorners(size)) corners.push_back(X_CO * p);

    const LabelImages labels = renderer.labels(viewFromOrigin(), stage.poses(), {stage.all()});

    EXPECT_LT(edgeError(labels.ids == 1, projectedHull(corners, kCamera)), 0.01) << "pose " << i;
  }
}

TEST(Renderer, ColourAndLabelsHaveTheSameOutline) {
  Stage stage;
  stage.addBox({0.8, 0.5, 0.6}, makePose({0.1, 0.2, 2.0}, Eigen::Quaterniond(0.9, 0.3, -0.2, 0.1)),
               0, coloured(1, 1, 1));
  Renderer renderer(unlit(), stage.links(), {});

  const cv::Mat image = renderer.colour(viewFromOrigin(), stage.poses(),
                                        {stage.all(), stage.all(), Sampling::kCentre});
  const LabelImages labels = renderer.labels(viewFromOrigin(), stage.poses(), {stage.all()});

  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  EXPECT_EQ(cv::norm(grey > 0, labels.ids == 1, cv::NORM_INF), 0.0);
}

TEST(Renderer, SmoothEdgesLieOnTheSameLineAsLabels) {
  // A white square on black: its brightness, summed up, is its area.
  const Eigen::Vector3d size(0.6, 0.6, 0.01);
  Stage stage;
  stage.addBox(size, makePose({0.013, -0.021, 1.5}, Eigen::Quaterniond(0.95, 0, 0, 0.3)), 0,
               coloured(1, 1, 1));
  Renderer renderer(unlit(), stage.links(), {});

  const cv::Mat image =
      renderer.colour(viewFromOrigin(), stage.poses(), {stage.all(), stage.all()});
  const LabelImages labels = renderer.labels(viewFromOrigin(), stage.poses(), {stage.all()});

  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  const cv::Moments smooth = cv::moments(grey);
  const cv::Moments sharp = cv::moments(labels.ids == 1, true);
  EXPECT_NEAR(smooth.m10 / smooth.m00, sharp.m10 / sharp.m00, 0.05);
  EXPECT_NEAR(smooth.m01 / smooth.m00, sharp.m01 / sharp.m00, 0.05);
}

TEST(Renderer, DepthIsTheDistanceAlongTheOpticalAxis) {
  // A tilted board: at each pixel the ray meets its front face at a depth known in closed form.
  const Pose X_CB = makePose(
      {0.0, 0.0, 3.0},
      Eigen::Quaterniond(Eigen::AngleAxisd(0.6, Eigen::Vector3d(0.3, 1.0, 0.0).normalized())));
  Stage stage;
  stage.addBox({8.0, 8.0, 0.2}, X_CB, 0);
  Renderer renderer(unlit(), stage.links(), {});

  const LabelImages labels = renderer.labels(viewFromOrigin(), stage.poses(), {stage.all()});

  const Eigen::Vector3d normal = X_CB.linear().col(2);
  const double offset = normal.dot(X_CB * Eigen::Vector3d(0, 0, -0.1));
  const Intrinsics& k = kCamera.intrinsics();
  for (int v = 40; v < 480; v += 37) {
    for (int u = 40; u < 640; u += 41) {
      const Eigen::Vector3d ray((u - k.cx) / k.fx, (v - k.cy) / k.fy, 1.0);
      const double truth = offset / normal.dot(ray);
      EXPECT_NEAR(labels.depth.at<float>(v, u), truth, 1e-4) << "pixel " << u << ", " << v;
    }
  }
}

TEST(Renderer, NearerObjectsHideFartherOnes) {
  Stage stage;
  stage.addBox({1, 1, 1}, at(0, 0, 5), 0);
  stage.addBox({0.2, 0.2, 0.2}, at(0, 0, 2), 1);
  stage.addBox({4, 4, 0.1}, at(0, 0, 8), -1);
  Renderer renderer(unlit(), stage.links(), {});

  const cv::Mat ids = renderer.labels(viewFromOrigin(), stage.poses(), {stage.all()}).ids;

  EXPECT_EQ(ids.at<int>(238, 322), 2);
  EXPECT_EQ(ids.at<int>(238, 322 + 50), 1);
  EXPECT_EQ(ids.at<int>(238, 322 + 120), 0) << "the world has no identifier";
}

TEST(Renderer, OnlySelectedLinksAreDrawn) {
  Stage stage;
  stage.addBox({1, 1, 1}, at(0, 0, 5), 0);
  stage.addBox({0.2, 0.2, 0.2}, at(0, 0, 2), 1);
  Renderer renderer(unlit(), stage.links(), {});

  const cv::Mat ids = renderer.labels(viewFromOrigin(), stage.poses(), {{true, false}}).ids;

  EXPECT_EQ(ids.at<int>(238, 322), 1);
}

TEST(Renderer, ThingsNearerThanTheNearPlaneAreNotSeen) {
  Stage stage;
  stage.addBox({1, 1, 0.01}, at(0, 0, 0.04), 0);
  Renderer renderer(unlit(), stage.links(), {});

  EXPECT_EQ(cv::countNonZero(renderer.labels(viewFromOrigin(), stage.poses(), {stage.all()}).ids),
            0);
}

TEST(Renderer, ColoursAreThoseOfTheMaterialInOpenCvsOrder) {
  Stage stage;
  stage.addBox({4, 4, 0.1}, at(0, 0, 3), -1, coloured(0.75F, 0.5F, 0.25F));
  world::Description description = unlit();
  Renderer renderer(description, stage.links(), {});
  // The board's normal is at 90 degrees to "up", where the ambient light is between its extremes.
  View view = viewFromOrigin();
  view.X_WC = makePose({0, 0, 0}, Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(),
                                                                     -Eigen::Vector3d::UnitZ()));
  stage.poses()[0] = at(0, 0, -3);

  const cv::Vec3b pixel =
      renderer.colour(view, stage.poses(), {stage.all(), stage.all()}).at<cv::Vec3b>(240, 320);

  EXPECT_NEAR(pixel[2], 191, 4) << "red";
  EXPECT_NEAR(pixel[1], 128, 4) << "green";
  EXPECT_NEAR(pixel[0], 64, 4) << "blue";
}

TEST(Renderer, TexturesStandTheRightWayUp) {
  // Four quarters, each of its own colour, on the face that looks at the camera.
  auto texture = std::make_shared<world::Texture>();
  texture->pixels.create(64, 64, CV_8UC4);
  texture->pixels(cv::Rect(0, 0, 32, 32)).setTo(cv::Scalar(0, 0, 255, 255));      // red
  texture->pixels(cv::Rect(32, 0, 32, 32)).setTo(cv::Scalar(0, 255, 0, 255));     // green
  texture->pixels(cv::Rect(0, 32, 32, 32)).setTo(cv::Scalar(255, 0, 0, 255));     // blue
  texture->pixels(cv::Rect(32, 32, 32, 32)).setTo(cv::Scalar(0, 255, 255, 255));  // yellow
  world::Material material = coloured(1, 1, 1);
  material.texture = texture;
  Stage stage;
  // The face -y seen from -y with z up: u to the right, v down.
  stage.addBox({2, 2, 2}, Pose::Identity(), -1, material);
  Renderer renderer(unlit(), stage.links(), {});
  View view = viewFromOrigin();
  Eigen::Matrix3d R_WC;
  R_WC.col(0) = Eigen::Vector3d::UnitX();
  R_WC.col(1) = -Eigen::Vector3d::UnitZ();
  R_WC.col(2) = Eigen::Vector3d::UnitY();
  view.X_WC = makePose({0, -4, 0}, Eigen::Quaterniond(R_WC));

  const cv::Mat image = renderer.colour(view, stage.poses(), {stage.all(), stage.all()});

  const auto brightest = [&](int u, int v) {
    const cv::Vec3b p = image.at<cv::Vec3b>(v, u);
    return std::string(p[2] > 100 ? "r" : "") + (p[1] > 100 ? "g" : "") + (p[0] > 100 ? "b" : "");
  };
  EXPECT_EQ(brightest(270, 190), "r") << "top left";
  EXPECT_EQ(brightest(370, 190), "g") << "top right";
  EXPECT_EQ(brightest(270, 290), "b") << "bottom left";
  EXPECT_EQ(brightest(370, 290), "rg") << "bottom right";
}

/// A floor with a box above it, seen from above, lit by one light.
class Shadows : public ::testing::Test {
 protected:
  Shadows() {
    description.ambient = {0.2F, 0.2F, 0.2F};
    world::Light light;
    light.casts_shadow = true;
    description.lights.push_back(light);
    stage.addBox({6, 6, 0.1}, at(0, 0, -0.05), -1, coloured(0.8F, 0.8F, 0.8F));
    stage.addBox({0.5, 0.5, 0.1}, at(0, 0, 1.0), 0, coloured(0.8F, 0.2F, 0.2F));
    Eigen::Matrix3d R_WC;  // looking down, the image's right is +x, its down is -y
    R_WC.col(0) = Eigen::Vector3d::UnitX();
    R_WC.col(1) = -Eigen::Vector3d::UnitY();
    R_WC.col(2) = -Eigen::Vector3d::UnitZ();
    view.X_WC = makePose({0, 0, 5}, Eigen::Quaterniond(R_WC));
  }

  /// The brightness of the floor at a place, once the picture has been taken.
  int floorAt(const cv::Mat& image, double x, double y) const {
    const auto pixel = kCamera.project(view.X_WC.inverse() * Eigen::Vector3d(x, y, 0));
    return image.at<cv::Vec3b>(static_cast<int>(std::lround(pixel->y())),
                               static_cast<int>(std::lround(pixel->x())))[1];
  }

  cv::Mat picture(const LinkSelection& casting) {
    Renderer renderer(description, stage.links(), {});
    return renderer.colour(view, stage.poses(), {stage.all(), casting});
  }

  world::Description description;
  Stage stage;
  View view = viewFromOrigin();
};

TEST_F(Shadows, OfParallelLightFallWhereItPoints) {
  description.lights[0].direction_L = Eigen::Vector3d(1, 0, -1).normalized();
  const cv::Mat image = picture(stage.all());
  // Light at 45 degrees along +x: the box's bottom (z 0.95) and top (1.05) throw their shadow from
  // x = -0.25 + 0.95 to 0.25 + 1.05.
  const int lit = floorAt(image, -1.0, 0.0);
  EXPECT_LT(floorAt(image, 1.0, 0.0), 0.7 * lit) << "in the middle of the shadow";
  EXPECT_LT(floorAt(image, 0.74, 0.2), 0.7 * lit) << "inside, near the shadow's edge";
  EXPECT_LT(floorAt(image, 1.26, -0.2), 0.7 * lit) << "inside, near the other edge";
  EXPECT_GT(floorAt(image, 0.66, 0.0), 0.95 * lit) << "outside, before the shadow";
  EXPECT_GT(floorAt(image, 1.34, 0.0), 0.95 * lit) << "outside, behind the shadow";
  EXPECT_GT(floorAt(image, 1.0, 0.29), 0.95 * lit) << "outside, beside the shadow";
}

TEST_F(Shadows, OfASpotLightSpreadFromTheLamp) {
  world::Light& light = description.lights[0];
  light.type = world::LightType::kSpot;
  light.X_WL = at(0.9, 0, 3.0);
  light.direction_L = Eigen::Vector3d(-0.2, 0, -1).normalized();
  light.spot_inner_angle = 1.6;
  light.spot_outer_angle = 2.0;
  light.range = 20.0;
  const cv::Mat image = picture(stage.all());
  // From (0.9, 3.0) past the bottom's edges at z 0.95: x = 0.9 + (e - 0.9) * 3 / 2.05.
  const double far_edge = 0.9 + (-0.25 - 0.9) * 3.0 / 2.05;
  const double near_edge = 0.9 + (0.25 - 0.9) * 3.0 / 1.95;
  EXPECT_LT(floorAt(image, far_edge + 0.08, 0.0), 0.6 * floorAt(image, far_edge - 0.08, 0.0));
  EXPECT_LT(floorAt(image, near_edge - 0.3, 0.0), 0.6 * floorAt(image, near_edge + 0.5, 0.0));
}

/// Shadow maps are kept from picture to picture if possible.
TEST_F(Shadows, AreTheSameWhateverWasDrawnBefore) {
  description.lights[0].direction_L = Eigen::Vector3d(1, 0, -1).normalized();
  world::Light lamp = description.lights[0];
  lamp.type = world::LightType::kSpot;
  lamp.X_WL = at(0.9, 0, 3.0);
  lamp.spot_inner_angle = 1.6;
  lamp.spot_outer_angle = 2.0;
  description.lights.push_back(lamp);
  stage.addBox({0.2, 0.2, 0.8}, at(-0.8, 0.5, 0.4), -1, coloured(0.2F, 0.8F, 0.2F));
  stage.addBox({6, 0.2, 2.5}, at(0, 2.5, 1.25), -1, coloured(0.5F, 0.5F, 0.5F));
  const std::vector<Pose> places = {at(0, 0, 1), at(0, 0, 1), at(0.3, 0, 1), at(-2, -2, 1),
                                    at(0, 0, 6), at(9, 9, 1), at(0.3, 0, 1)};
  std::vector<cv::Mat> images;
  {
    Renderer renderer(description, stage.links(), {});
    for (const Pose& place : places) {
      stage.poses()[1] = place;
      const LinkSelection floor = {true, false, false, false};
      (void)renderer.colour(view, stage.poses(), {stage.all(), floor});
      (void)renderer.colour(view, stage.poses(), {stage.all(), stage.all()});
      images.push_back(renderer.colour(view, stage.poses(), {stage.all(), stage.all()}));
    }
    for (const Pose& place : places) {
      stage.poses()[1] = place;
      images.push_back(renderer.colour(view, stage.poses(), {stage.all(), stage.all()}));
    }
  }
  for (std::size_t i = 0; i < images.size(); ++i) {
    stage.poses()[1] = places[i % places.size()];
    EXPECT_EQ(cv::norm(images[i], picture(stage.all()), cv::NORM_INF), 0.0) << "picture " << i;
  }
}

TEST_F(Shadows, AreThrownByCastingLinksAlone) {
  description.lights[0].direction_L = Eigen::Vector3d(1, 0, -1).normalized();
  const cv::Mat image = picture({true, false});
  EXPECT_NEAR(floorAt(image, 1.0, 0.0), floorAt(image, -1.0, 0.0), 1);
}

TEST_F(Shadows, DoNotSpeckleLitSurfaces) {
  description.lights[0].direction_L = Eigen::Vector3d(1, 0.3, -0.35).normalized();  // grazing
  const cv::Mat image = picture({true, false});
  double lowest = 0.0;
  double highest = 0.0;
  cv::Mat green;
  cv::extractChannel(image, green, 1);
  const auto corner = kCamera.project(view.X_WC.inverse() * Eigen::Vector3d(-2, 1.5, 0));
  const auto opposite = kCamera.project(view.X_WC.inverse() * Eigen::Vector3d(-0.5, -1.5, 0));
  const cv::Rect floor(cv::Point2d(corner->x(), corner->y()),
                       cv::Point2d(opposite->x(), opposite->y()));
  cv::minMaxLoc(green(floor), &lowest, &highest);
  EXPECT_LE(highest - lowest, 2.0);
}

TEST(Renderer, SameCallsGiveSamePixels) {
  const auto draw = [] {
    Stage stage;
    stage.addBox({1, 1, 1}, makePose({0.1, 0, 4}, Eigen::Quaterniond(0.9, 0.1, 0.4, 0.2)), 0);
    world::Description description;
    description.simulator = world::Simulator::kGz;
    description.lights.emplace_back();
    Renderer renderer(description, stage.links(), {});
    return renderer.colour(viewFromOrigin(), stage.poses(), {stage.all(), stage.all()});
  };
  EXPECT_EQ(cv::norm(draw(), draw(), cv::NORM_INF), 0.0);
}

TEST(Renderer, SeesFarFromTheOriginAsClearlyAsAtIt) {
  // A map in UTM coordinates: half a million metres from the origin.
  const Pose X_WM = at(500000.25, 4500000.5, 0.0);
  Stage stage;
  stage.addBox({0.8, 0.5, 0.6}, makePose({0.1, 0.2, 2.0}, Eigen::Quaterniond(0.9, 0.3, -0.2, 0.1)),
               0);
  Renderer renderer(unlit(), stage.links(), {});
  const cv::Mat here = renderer.labels(viewFromOrigin(), stage.poses(), {stage.all()}).ids;
  stage.poses()[0] = X_WM * stage.poses()[0];

  const cv::Mat there = renderer.labels({kCamera, X_WM}, stage.poses(), {stage.all()}).ids;

  EXPECT_LE(cv::countNonZero(here != there), 2);
}

/// The code for the first eight lights is compiled differently from that for the others.
TEST(Renderer, ManyLightsAddUp) {
  Stage stage;
  stage.addBox({1, 1, 1}, makePose({0, 0, 4}, Eigen::Quaterniond(0.9, 0.1, 0.4, 0.2)), -1,
               coloured(0.8F, 0.7F, 0.6F));
  world::Description description;
  description.simulator = world::Simulator::kGz;
  description.ambient = description.background = {0.0F, 0.0F, 0.0F};
  world::Light lamp;
  lamp.type = world::LightType::kPoint;
  lamp.X_WL = at(0.5, -1, 1);
  lamp.casts_shadow = false;
  lamp.diffuse = {0.75F, 0.75F, 0.75F};
  const auto pictureWith = [&](std::size_t count) {
    world::Light each = lamp;
    each.diffuse /= static_cast<float>(count);
    description.lights.assign(count, each);
    Renderer renderer(description, stage.links(), {});
    return renderer.colour(viewFromOrigin(), stage.poses(), {stage.all(), stage.all()});
  };
  const cv::Mat one = pictureWith(1);
  EXPECT_GT(cv::norm(one, cv::NORM_INF), 100.0);
  for (const std::size_t count : {8U, 9U, 12U, 32U}) {
    EXPECT_LE(cv::norm(one, pictureWith(count), cv::NORM_INF), 1.0) << count;
  }
}

TEST_F(Shadows, AreThrownByAnyOfManyLights) {
  description.lights[0].direction_L = Eigen::Vector3d(1, 0, -1).normalized();
  const cv::Mat first = picture(stage.all());
  world::Light nothing = description.lights[0];
  nothing.type = world::LightType::kPoint;
  nothing.casts_shadow = false;
  nothing.diffuse = nothing.specular = {0.0F, 0.0F, 0.0F};
  description.lights.insert(description.lights.begin(), 10, nothing);
  EXPECT_EQ(cv::norm(first, picture(stage.all()), cv::NORM_INF), 0.0);
}

}  // namespace renderer_test
}  // namespace synthetic_dataset::render
