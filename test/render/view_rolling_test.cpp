/// Pictures whose rows are taken one after the other, against a picture for each row.

#include "render/view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "render/lens_cases.h"
#include "render/renderer.h"
#include "support/box_world.h"
#include "world/physics/ray_caster.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::render {
namespace rolling_view_test {

using test::coloured;

constexpr int kWidth = 320;
constexpr int kHeight = 240;

Pose turned(double x, double y, double z, double angle) {
  return makePose({x, y, z}, Eigen::Quaterniond(
                                 Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized())));
}

/// How the camera moves, and through which lens it looks.
struct Case {
  const char* name;
  bool rides;
  Distortion distortion;
};

/// A wall, a floor and a box that stand, and a ball, a box and a wheel that move and turn fast.
class RollingPicture : public testing::TestWithParam<Case> {
 protected:
  RollingPicture() : description(test::dark()) {
    stage.addBox({8, 6, 0.2}, turned(0, 0, 6, 0), -1, coloured(0.8F, 0.8F, 0.7F));
    stage.addBox({8, 0.2, 8}, turned(0, 1.2, 3, 0), -1, coloured(0.4F, 0.5F, 0.4F));
    stage.addBox({0.5, 2.4, 0.5}, turned(-0.8, 0, 4, 0.3), -1, coloured(0.3F, 0.3F, 0.9F));
    stage.addMesh(world::sphereMesh(0.4), {}, 0, coloured(0.9F, 0.2F, 0.2F));
    stage.addBox({0.7, 0.7, 0.7}, {}, 1, coloured(0.9F, 0.9F, 0.1F));
    stage.addBox({1.6, 0.1, 0.1}, {}, 2, coloured(0.1F, 0.9F, 0.9F));
  }

  void shineSun() {
    world::Light sun;
    sun.casts_shadow = true;
    sun.direction_L = Eigen::Vector3d(0.3, 1, 0.4).normalized();
    description.lights = {sun};
    description.ambient = {0.3F, 0.3F, 0.3F};
  }

  /// @param share  how much of the readout has passed
  [[nodiscard]] RollingMoment momentAt(double share) const {
    RollingMoment moment{share * kHeight - 0.5, Pose::Identity(), stage.poses()};
    if (GetParam().rides) {
      moment.X_WC =
          makePose({0.3 * share, 0.05 * share, 0.1 * share},
                   Eigen::Quaterniond(Eigen::AngleAxisd(0.05 * share, Eigen::Vector3d::UnitY())));
    }
    moment.X_WL[3] = turned(-0.2 + 0.8 * share, -0.3, 2.5, 0);
    moment.X_WL[4] = turned(0.9 - 0.5 * share, 0.6, 3, share);
    moment.X_WL[5] = turned(0.6, -0.7, 3, 2.5 * share);
    return moment;
  }

  [[nodiscard]] RollingView view() const {
    RollingView result{CameraModel(kWidth, kHeight, {260.0, 260.0, 159.5, 119.5}, 0.05, 100.0,
                                   GetParam().distortion),
                       {},
                       8};
    for (int i = 0; i <= 8; ++i) result.moments.push_back(momentAt(i / 8.0));
    return result;
  }

  [[nodiscard]] ColourPass pass(Sampling sampling) const {
    return {stage.all(), stage.all(), sampling};
  }

  /// How many pixels of a picture differ by more than one grey level from those of a picture taken
  /// entirely at their row's time.
  [[nodiscard]] int unlikeTheirRows(Renderer& renderer, const RollingView& rolling,
                                    Sampling sampling, const cv::Mat& picture) const {
    int different = 0;
    for (int row = 0; row < kHeight; ++row) {
      const RollingMoment now = rolling.at(row);
      ColourPass of_row = pass(sampling);
      of_row.regions = {cv::Rect(0, row, kWidth, 1)};
      const cv::Mat expected = renderer.colour({rolling.camera, now.X_WC}, now.X_WL, of_row);
      cv::Mat difference;
      cv::absdiff(picture.row(row), expected.row(row), difference);
      for (int u = 0; u < kWidth; ++u) {
        const auto& pixel = difference.at<cv::Vec3b>(0, u);
        different += std::max({pixel[0], pixel[1], pixel[2]}) > 1 ? 1 : 0;
      }
    }
    return different;
  }

  world::Description description;
  test::Stage stage;
};

TEST_P(RollingPicture, ShowsInEachRowWhatAPictureOfItsTimeShows) {
  Renderer renderer(description, stage.links(), {});
  const RollingView rolling = view();
  for (const Sampling sampling : {Sampling::kCentre, Sampling::kSmooth}) {
    const cv::Mat picture = renderer.draw(rolling, pass(sampling))();
    test::keep(picture, std::string("rolling_") + GetParam().name);
    // An edge takes its light from pixels above and below, which are of other times.
    const bool is_smooth = sampling == Sampling::kSmooth;
    EXPECT_LT(unlikeTheirRows(renderer, rolling, sampling, picture),
              kWidth * kHeight * (is_smooth ? 3 : 1) / 1000)
        << is_smooth;
  }
}

TEST_P(RollingPicture, ShowsInEachRowWhatTurnsBackAtOnce) {
  Renderer renderer(description, stage.links(), {});
  RollingView rolling = view();
  for (std::size_t i = 0; i < rolling.moments.size(); ++i) {
    rolling.moments[i].X_WL[3] = turned(-0.1, i % 2 == 0 ? -0.35 : 0.05, 2.5, 0);
  }
  const cv::Mat picture = renderer.draw(rolling, pass(Sampling::kCentre))();
  test::keep(picture, std::string("rolling_back_") + GetParam().name);
  EXPECT_LT(unlikeTheirRows(renderer, rolling, Sampling::kCentre, picture),
            kWidth * kHeight / 1000);
}

TEST_P(RollingPicture, IsThatOfWhichNothingWasKept) {
  shineSun();
  for (const LightDetail light : {LightDetail::kSimple, LightDetail::kFull}) {
    RenderOptions options;
    options.light = light;
    std::vector<cv::Mat> kept;
    {
      Renderer renderer(description, stage.links(), options);
      for (int i = 0; i < 3; ++i) {
        kept.push_back(renderer.draw(view(), pass(Sampling::kSmooth))());
        if (i == 0) (void)renderer.labels({view().camera, {}}, stage.poses(), {stage.all()});
      }
    }
    options.reuse = false;
    Renderer renderer(description, stage.links(), options);
    const cv::Mat expected = renderer.draw(view(), pass(Sampling::kSmooth))();
    for (const cv::Mat& picture : kept) {
      EXPECT_EQ(cv::norm(picture, expected, cv::NORM_INF), 0.0);
    }
  }
}

TEST_P(RollingPicture, ExposuresHaveThePicturesOfTheirMoments) {
  shineSun();
  Renderer renderer(description, stage.links(), {});
  std::vector<RollingMoment> moments;
  for (int i = 0; i < 4; ++i) moments.push_back(momentAt(0.001 * i));
  std::vector<PendingPicture> pictures;
  renderer.drawExposure(view().camera, moments, pass(Sampling::kSmooth),
                        [&](PendingPicture picture) { pictures.push_back(std::move(picture)); });
  ASSERT_EQ(pictures.size(), moments.size());
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const cv::Mat expected =
        renderer.colour({view().camera, moments[i].X_WC}, moments[i].X_WL, pass(Sampling::kSmooth));
    cv::Mat difference;
    cv::absdiff(pictures[i](), expected, difference);
    cv::Mat differs;
    cv::inRange(difference, cv::Scalar::all(0), cv::Scalar::all(1), differs);
    // The rims of shadows follow the texels of their maps, which lie elsewhere.
    EXPECT_LT(kWidth * kHeight - cv::countNonZero(differs), kWidth * kHeight / 50);
    EXPECT_LT(cv::mean(difference.reshape(1))[0], 0.2);
  }
}

TEST_P(RollingPicture, HasItsRowsUnderASkyInBands) {
  description.sky = world::Sky();
  Renderer renderer(description, stage.links(), {});
  const RollingView rolling = view();
  const cv::Mat picture = renderer.draw(rolling, pass(Sampling::kSmooth))();
  const cv::Rect rows = rolling.rowsOf(3);
  const RollingMoment middle = rolling.at(rows.y + 0.5 * (rows.height - 1));
  const cv::Mat expected =
      renderer.colour({rolling.camera, middle.X_WC}, middle.X_WL, pass(Sampling::kSmooth));
  EXPECT_EQ(cv::norm(picture(rows), expected(rows), cv::NORM_INF), 0.0);
}

/// Ray casts at the time of one row.
class RowOfRays {
 public:
  RowOfRays(const test::Stage& stage, const RollingView& view, int row)
      : moment_(view.at(row)), camera_(view.camera), rays_(stage.links(), moment_.X_WL) {}

  /// The index + 1 of the link that is hit, 0 for none, and its distance.
  [[nodiscard]] std::pair<int, double> look(const Eigen::Vector2d& pixel) const {
    const auto ray_C = camera_.ray(pixel);
    if (!ray_C) return {-1, 0.0};
    const auto hit =
        rays_.cast(moment_.X_WC.translation(), moment_.X_WC.linear() * *ray_C, camera_.far());
    return hit ? std::pair(static_cast<int>(hit->link) + 1, hit->distance) : std::pair(0, 0.0);
  }

  /// Whether another link or a jump in distance is within a small step.
  [[nodiscard]] bool isEdge(const Eigen::Vector2d& pixel) const {
    constexpr double kStep = 0.05;  // [px]
    const auto here = look(pixel);
    for (int i = 0; i < 9; ++i) {
      const auto there = look(pixel + kStep * Eigen::Vector2d(i % 3 - 1, i / 3 - 1));
      if (there.first != here.first || std::abs(there.second - here.second) > 0.003) return true;
    }
    return false;
  }

 private:
  RollingMoment moment_;
  const CameraModel& camera_;
  world::RayCaster rays_;
};

TEST_P(RollingPicture, ItsLabelsAreWhatRaysMeetAtTheTimesOfTheirRows) {
  Renderer renderer(description, stage.links(), {});
  const RollingView rolling = view();
  LabelPass pass{stage.all()};
  pass.links = pass.range = pass.normals = true;
  const LabelImages labels = renderer.labels(rolling, pass);
  int edges = 0;
  for (int row = 0; row < kHeight; ++row) {
    const RowOfRays rays(stage, rolling, row);
    for (int u = 0; u < kWidth; ++u) {
      const auto [link, range] = rays.look(Eigen::Vector2d(u, row));
      if (link < 0) continue;
      const int found = labels.links.at<int>(row, u);
      const double distance = double{labels.range.at<float>(row, u)};
      const double z = rolling.camera.ray(Eigen::Vector2d(u, row))->z();
      ASSERT_NEAR(double{labels.depth.at<float>(row, u)}, distance * z, 1e-5) << u << ", " << row;
      if (found != link || std::abs(distance - range) > 1e-3) {
        EXPECT_TRUE(rays.isEdge(Eigen::Vector2d(u, row)))
            << u << ", " << row << ": " << found << ", and a ray meets " << link;
        ++edges;
      }
      const int object = link == 0 ? -1 : stage.links()[static_cast<std::size_t>(link - 1)].object;
      if (found == link) {
        ASSERT_EQ(labels.ids.at<int>(row, u), object + 1);
      }
    }
  }
  EXPECT_LT(edges, kWidth * kHeight / 2000);
}

TEST_P(RollingPicture, ItsNormalsAreThoseOfTheSurfacesAtTheTimesOfTheirRows) {
  Renderer renderer(description, stage.links(), {});
  const RollingView rolling = view();
  LabelPass pass{stage.all()};
  pass.normals = true;
  const LabelImages labels = renderer.labels(rolling, pass);
  int different = 0;
  for (int row = 0; row < kHeight; row += 7) {
    const RollingMoment now = rolling.at(row);
    const LabelImages expected = renderer.labels({rolling.camera, now.X_WC}, now.X_WL, pass);
    for (int u = 0; u < kWidth; ++u) {
      const auto& found = labels.normals.at<cv::Vec3f>(row, u);
      different += cv::norm(found - expected.normals.at<cv::Vec3f>(row, u)) > 0.01 ? 1 : 0;
    }
  }
  EXPECT_LT(different, kWidth * kHeight / 7 / 500);
}

TEST_P(RollingPicture, ItsSilhouettesAreWhatItsLabelsHaveOfEachObjectAlone) {
  Renderer renderer(description, stage.links(), {});
  const RollingView rolling = view();
  for (std::size_t link = 3; link < 6; ++link) {
    LinkSelection alone(stage.links().size(), false);
    alone[link] = true;
    const Silhouette silhouette = renderer.silhouette(rolling, alone);
    const cv::Mat expected = renderer.labels(rolling, {alone}).ids > 0;
    cv::Mat covered = cv::Mat::zeros(expected.size(), CV_8UC1);
    silhouette.mask.pixels().copyTo(covered(silhouette.mask.bounds()));
    EXPECT_EQ(cv::norm(covered, expected, cv::NORM_INF), 0.0) << link;
    EXPECT_EQ(silhouette.pixels_in_image, cv::countNonZero(expected)) << link;
  }
}

/// Pinholes only: outside of other lenses' images, pixels are counted by cell.
class RollingPinhole : public RollingPicture {};

TEST_P(RollingPinhole, ItsSilhouettesGoOnBesideTheImage) {
  Renderer renderer(description, stage.links(), {});
  RollingView rolling = view();
  // The ball enters from the left.
  for (std::size_t i = 0; i < rolling.moments.size(); ++i) {
    rolling.moments[i].X_WL[3] = turned(-1.9 + 0.06 * static_cast<double>(i), -0.1, 2.5, 0);
  }
  LinkSelection ball(stage.links().size(), false);
  ball[3] = true;
  const Silhouette silhouette = renderer.silhouette(rolling, ball);
  // A picture of the same rows that is wider.
  RollingView wide = rolling;
  Intrinsics k = rolling.camera.intrinsics();
  k.cx += kWidth;
  wide.camera = CameraModel(3 * kWidth, kHeight, k, 0.05, 100.0);
  const cv::Mat whole = renderer.labels(wide, {ball}).ids > 0;
  const int all = cv::countNonZero(whole);
  ASSERT_GT(silhouette.pixels_in_image, 0);
  ASSERT_LT(silhouette.pixels_in_image, all);
  EXPECT_NEAR(static_cast<double>(silhouette.pixels), all, 0.01 * all);
  const cv::Rect bounds = cv::boundingRect(whole);
  ASSERT_TRUE(silhouette.box.has_value());
  EXPECT_NEAR(silhouette.box->left, bounds.x - kWidth - 0.5, 3.0);
  EXPECT_NEAR(silhouette.box->right, bounds.br().x - kWidth - 0.5, 3.0);
}

const Case kStands{"stands", false, {}};
const Case kRides{"rides", true, {}};

std::string nameOf(const testing::TestParamInfo<Case>& each) { return each.param.name; }

INSTANTIATE_TEST_SUITE_P(
    Cameras, RollingPicture,
    testing::Values(kStands, kRides,
                    Case{"stands_plumb_bob", false, test::kPlumbBob.camera.distortion()},
                    Case{"rides_plumb_bob", true, test::kPlumbBob.camera.distortion()}),
    nameOf);
INSTANTIATE_TEST_SUITE_P(Cameras, RollingPinhole, testing::Values(kStands, kRides), nameOf);

}  // namespace rolling_view_test
}  // namespace synthetic_dataset::render
