#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "render/lens_cases.h"
#include "render/pixels/srgb.h"
#include "render/renderer.h"
#include "support/box_world.h"

namespace synthetic_dataset::render {
namespace lens_room_test {

using synthetic_dataset::test::Stage;
using test::coloured;
using test::keep;
using test::kFisheye190;
using test::kPlumbBob;

/// A closed room with striped walls, the camera in its middle.
class Room : public ::testing::Test {
 protected:
  Room() {
    description.ambient = {0.5F, 0.5F, 0.5F};
    auto texture = std::make_shared<world::Texture>();
    texture->pixels.create(256, 256, CV_8UC4);
    for (int v = 0; v < 256; ++v) {
      for (int u = 0; u < 256; ++u) {
        const bool bright = ((u / 16) + (v / 16)) % 2 == 0;
        texture->pixels.at<cv::Vec4b>(v, u) =
            bright ? cv::Vec4b(220, 225, 230, 255) : cv::Vec4b(60, 70, 110, 255);
      }
    }
    world::Material wall = coloured(1, 1, 1);
    wall.texture = texture;
    const auto at = [](double x, double y, double z) {
      return makePose({x, y, z}, Eigen::Quaterniond::Identity());
    };
    stage.addBox({6, 6, 0.1}, at(0, 0, -0.05), -1, wall);
    stage.addBox({6, 0.1, 3}, at(0, 3, 1.5), -1, wall);
    stage.addBox({6, 0.1, 3}, at(0, -3, 1.5), -1, wall);
    stage.addBox({0.1, 6, 3}, at(3, 0, 1.5), -1, wall);
    stage.addBox({0.1, 6, 3}, at(-3, 0, 1.5), -1, wall);
    stage.addBox({0.6, 0.6, 1.2}, at(1.5, 0.8, 0.6), 0, coloured(0.8F, 0.2F, 0.1F));
    stage.addBox({0.4, 0.4, 0.8}, at(0.2, 1.8, 0.4), 1, coloured(0.1F, 0.3F, 0.8F));
    stage.addBox({0.4, 0.4, 0.8}, at(0.3, -1.2, 0.4), 2, coloured(0.2F, 0.7F, 0.2F));
    world::Light sun;
    sun.casts_shadow = true;
    sun.direction_L = Eigen::Vector3d(0.4, 0.3, -1).normalized();
    sun.diffuse = {0.7F, 0.7F, 0.65F};
    description.lights.push_back(sun);
    Eigen::Matrix3d R_WC;  // looking along +x, a little down
    R_WC << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    X_WC = makePose({0, 0, 1.4},
                    Eigen::Quaterniond(R_WC * Eigen::AngleAxisd(-0.25, Eigen::Vector3d::UnitX())));
  }

  cv::Mat picture(const CameraModel& camera) {
    Renderer renderer(description, stage.links(), {});
    return renderer.colour({camera, X_WC}, stage.poses(), {stage.all(), stage.all()});
  }

  world::Description description;
  Stage stage;
  Pose X_WC;
};

TEST_F(Room, ThroughALensIsThePinholesPictureRemapped) {
  // The pinhole picture at twice the density, looked up where each pixel's ray falls.
  const CameraModel& lens = kPlumbBob.camera;
  const CameraModel pinhole(1600, 1200, {800, 800, 799.5, 599.5}, 0.05, 100.0);
  const cv::Mat image = picture(lens);
  cv::Mat sharp = picture(pinhole);
  cv::GaussianBlur(sharp, sharp, {}, 0.6);
  cv::Mat places(lens.height(), lens.width(), CV_32FC2, cv::Scalar(-1, -1));
  for (int v = 0; v < lens.height(); ++v) {
    for (int u = 0; u < lens.width(); ++u) {
      const Eigen::Vector2d place = *pinhole.project(5.0 * *lens.ray({u, v}));
      places.at<cv::Vec2f>(v, u) = {static_cast<float>(place.x()), static_cast<float>(place.y())};
    }
  }
  cv::Mat expected;
  cv::remap(sharp, expected, places, cv::noArray(), cv::INTER_LINEAR);
  cv::Mat difference;
  cv::absdiff(image, expected, difference);
  EXPECT_LT(cv::mean(difference)[1], 3.0);
  keep(image, "room_plumb_bob");
  keep(expected, "room_plumb_bob_expected");
}

/// The picture of a lens, with each pixel the mean light of many rays.
/// @param sharp  a pinhole's picture with four times the lens's pixel density
cv::Mat meanOfManyRays(const CameraModel& lens, const CameraModel& pinhole, const cv::Mat& sharp) {
  constexpr int kRays = 4;  // in each direction
  cv::Mat means(lens.height(), lens.width(), CV_8UC3);
  for (int v = 0; v < lens.height(); ++v) {
    for (int u = 0; u < lens.width(); ++u) {
      cv::Vec3f sum(0.0F, 0.0F, 0.0F);
      for (int i = 0; i < kRays * kRays; ++i) {
        const Eigen::Vector2d within((i % kRays + 0.5) / kRays - 0.5,
                                     (i / kRays + 0.5) / kRays - 0.5);
        const Eigen::Vector2d at =
            *pinhole.project(5.0 * *lens.ray(within + Eigen::Vector2d(u, v)));
        const auto& seen = sharp.at<cv::Vec3b>(cvRound(at.y()), cvRound(at.x()));
        for (int c = 0; c < 3; ++c) sum[c] += linearFromSrgb()[seen[c]];
      }
      for (int c = 0; c < 3; ++c) {
        means.at<cv::Vec3b>(v, u)[c] = srgbFromLinear(sum[c] / (kRays * kRays));
      }
    }
  }
  return means;
}

TEST_F(Room, ThroughALensIsTheMeanOfManyRays) {
  const CameraModel lens(320, 240, {210.2, 209.05, 160.6, 118.85}, 0.05, 100.0,
                         kPlumbBob.camera.distortion());
  const CameraModel pinhole(1800, 1400, {840, 840, 899.5, 699.5}, 0.05, 100.0);
  const cv::Mat image = picture(lens);

  const cv::Mat expected = meanOfManyRays(lens, pinhole, picture(pinhole));

  cv::Mat changes;
  cv::morphologyEx(expected, changes, cv::MORPH_GRADIENT, cv::Mat::ones(3, 3, CV_8UC1));
  int even = 0;
  int differing = 0;
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      constexpr int kEven = 6;  // a greater change between neighbouring pixels is an edge
      const auto& change = changes.at<cv::Vec3b>(v, u);
      if (std::max({change[0], change[1], change[2]}) > kEven) continue;
      ++even;
      const double difference =
          cv::norm(cv::Vec3i(image.at<cv::Vec3b>(v, u)) - cv::Vec3i(expected.at<cv::Vec3b>(v, u)),
                   cv::NORM_INF);
      if (difference > 1.0) ++differing;
    }
  }
  EXPECT_GT(even, image.rows * image.cols / 3);
  EXPECT_LT(differing, even / 1000);
  cv::Mat difference;
  cv::absdiff(image, expected, difference);
  EXPECT_LT(cv::mean(difference)[1], 2.0) << "edges with four rays beside sixteen";
  keep(image, "room_lit_once");
  keep(expected, "room_lit_once_expected");
}

TEST_F(Room, LooksTheSameOnBothSidesOfAFacesEdge) {
  // Rolling the camera moves the seams between faces across the room; the view in each direction
  // has to stay the same.
  const CameraModel& lens = kFisheye190.camera;
  const cv::Mat straight = picture(lens);
  const Eigen::AngleAxisd turn(0.5, Eigen::Vector3d::UnitZ());
  X_WC = X_WC * Pose(turn);
  const cv::Mat turned = picture(lens);
  cv::Mat places(lens.height(), lens.width(), CV_32FC2, cv::Scalar(-1, -1));
  cv::Mat both(lens.height(), lens.width(), CV_8UC1, cv::Scalar(0));
  for (int v = 0; v < lens.height(); ++v) {
    for (int u = 0; u < lens.width(); ++u) {
      const auto ray = lens.ray({u, v});
      if (!ray || std::acos(ray->z()) > 1.6) continue;
      const auto place = lens.project(turn.inverse() * *ray);
      if (!place || !intersection(lens.imageBounds(), Box{place->x() - 3, place->y() - 3,
                                                          place->x() + 3, place->y() + 3})) {
        continue;
      }
      places.at<cv::Vec2f>(v, u) = {static_cast<float>(place->x()), static_cast<float>(place->y())};
      both.at<unsigned char>(v, u) = 255;
    }
  }
  cv::Mat expected;
  cv::remap(turned, expected, places, cv::noArray(), cv::INTER_LINEAR);
  cv::Mat difference;
  cv::absdiff(straight, expected, difference);
  difference.setTo(cv::Scalar::all(0), both == 0);
  cv::GaussianBlur(difference, difference, {9, 9}, 2.0);
  double worst = 0.0;
  cv::minMaxLoc(difference.reshape(1), nullptr, &worst);
  EXPECT_LT(worst, 40.0) << "a seam, or a shadow that one face has and its neighbour lacks";
  EXPECT_LT(cv::mean(difference, both)[1], 5.0);
  keep(straight, "room_fisheye_190");
  keep(turned, "room_fisheye_190_turned");
  keep(difference, "room_fisheye_190_difference");
}

TEST_F(Room, StaysTheSameWithoutDistortion) {
  // A distortion of zeros is drawn another way and has to show the same picture.
  const CameraModel plain(640, 480, {400, 400, 319.5, 239.5}, 0.05, 100.0);
  const CameraModel zeros(640, 480, {400, 400, 319.5, 239.5}, 0.05, 100.0,
                          {DistortionModel::kPlumbBob, {}});
  cv::Mat difference;
  const cv::Mat expected = picture(plain);
  const cv::Mat image = picture(zeros);
  cv::absdiff(image, expected, difference);
  EXPECT_LT(cv::mean(difference)[1], 2.0);
  keep(expected, "room_pinhole");
  keep(image, "room_zeros");
}

}  // namespace lens_room_test
}  // namespace synthetic_dataset::render
