/// Pictures that keep most pixels of the one before, against pictures that are drawn anew.

#include <map>
#include <string>
#include <thread>
#include <tuple>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/lens_cases.h"
#include "render/renderer.h"
#include "support/box_world.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::render {
namespace picture_painter_test {

using test::Stage;

Pose at(double x, double y, double z) {
  return makePose({x, y, z}, Eigen::Quaterniond::Identity());
}

world::Material coloured(float red, float green, float blue, float alpha = 1.0F) {
  world::Material material;
  material.diffuse = {red, green, blue, alpha};
  return material;
}

/// A yard under a sunny sky with a lamp: walls, a pane of glass in front of part of them, and two
/// balls, a cup of glass and a rod that move; the rod is thinner than a pixel. `kWithoutGlass` is
/// the same without glass: OpenGL then draws other shadows. `kThroughALens` has neither glass nor
/// sky, and each pixel has its own ray through a lens; `kSkyThroughALens` adds the sky, with which
/// pixels have no rays of their own. Under gz-sim's light, one of the balls is a mirror.
enum class Yard { kWithGlass, kWithoutGlass, kThroughALens, kSkyThroughALens };

struct Case {
  Yard yard;
  LightDetail light = LightDetail::kSimple;
  world::Simulator simulator = world::Simulator::kClassic;
};

world::Material mirror() {
  world::Material material = coloured(0.9F, 0.8F, 0.8F);
  material.metalness = 1.0F;
  material.roughness = 0.1F;
  return material;
}

class KeptPictures : public testing::TestWithParam<Case> {
 protected:
  static constexpr std::size_t kBall = 4;

  KeptPictures() {
    options.light = GetParam().light;
    const bool has_glass = GetParam().yard == Yard::kWithGlass;
    description.ambient = {0.3F, 0.3F, 0.3F};
    description.simulator = GetParam().simulator;
    const bool is_open = GetParam().yard != Yard::kThroughALens;
    if (!is_open || GetParam().yard == Yard::kSkyThroughALens) {
      view.camera = CameraModel(320, 240, {260.0, 260.0, 159.5, 119.5}, 0.05, 100.0,
                                test::kPlumbBob.camera.distortion());
    }
    if (is_open) description.sky = world::Sky();
    world::Light sun;
    sun.casts_shadow = true;
    sun.direction_L = Eigen::Vector3d(0.5, 0.2, -1).normalized();
    world::Light lamp = sun;
    lamp.type = world::LightType::kSpot;
    lamp.X_WL = at(1.0, 0.5, 2.5);
    lamp.direction_L = -Eigen::Vector3d::UnitZ();
    lamp.spot_inner_angle = 1.2;
    lamp.spot_outer_angle = 1.8;
    lamp.range = 6.0;
    world::Light point_light = lamp;
    point_light.type = world::LightType::kPoint;
    point_light.X_WL = at(-1.0, -0.6, 1.0);
    point_light.diffuse.setConstant(0.4F);
    description.lights = {sun, lamp, point_light};
    stage.addBox({8, 8, 0.2}, at(0, 0, -0.1), -1, coloured(0.8F, 0.8F, 0.7F));
    stage.addBox({0.2, 6, 1.5}, at(2, 0, 0.75), -1, coloured(0.7F, 0.4F, 0.3F));
    stage.addBox({0.4, 0.4, 0.6}, at(-0.5, 1, 0.3), -1, coloured(0.3F, 0.6F, 0.3F));
    stage.addBox({0.02, 1, 1}, at(0.5, -1, 0.5), -1,
                 coloured(0.5F, 0.7F, 0.9F, has_glass ? 0.4F : 1.0F));
    stage.addMesh(world::sphereMesh(0.3), at(0, 0, 0.3), 0, coloured(0.9F, 0.2F, 0.2F));
    stage.addMesh(
        world::sphereMesh(0.2), at(0, -1, 0.2), 1,
        description.simulator == world::Simulator::kGz ? mirror() : coloured(0.2F, 0.2F, 0.9F));
    stage.addBox({0.3, 0.3, 0.3}, at(-1, 0, 0.15), 2,
                 coloured(0.9F, 0.9F, 0.9F, has_glass ? 0.5F : 1.0F));
    stage.addBox({0.003, 0.003, 1.8}, at(1.5, 0.5, 0.9), 3, coloured(0.1F, 0.1F, 0.1F));
    Eigen::Matrix3d R_WC;  // along +x, a little downwards
    R_WC << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    view.X_WC = makePose(
        {-3, 0, 1.2}, Eigen::Quaterniond(R_WC) * Eigen::AngleAxisd(-0.2, Eigen::Vector3d::UnitX()));
  }

  /// Moves what moves to where it is at a time.
  void move(int time) {
    const double t = 0.1 * time;
    stage.poses()[kBall] = at(0.5 * std::sin(3 * t), std::cos(2 * t), 0.3 + 0.2 * t);
    stage.poses()[kBall + 1] = time == 3 ? at(-20, 0, 0.2) : at(1.2, t - 1, 0.2);
    stage.poses()[kBall + 2] = at(-1, t - 0.5, 0.15);
    // At time 4 the rod reaches from below the spot light to above it; at time 5 all of it is
    // above.
    const double height = time == 4 ? 2.2 : time == 5 ? 4.0 : 0.9;
    stage.poses()[kBall + 3] = at(1.5, 0.5 - 1.3 * t, height);
  }

  [[nodiscard]] cv::Mat draw(Renderer& renderer) const {
    return renderer.colour(view, stage.poses(), {stage.all(), stage.all()});
  }

  /// The picture of a time, by a renderer that has drawn no other. Tests share these pictures, as
  /// making a renderer takes longer than drawing.
  [[nodiscard]] cv::Mat drawnAnew(int time) {
    using Key = std::tuple<Yard, LightDetail, world::Simulator, int, int, double, int>;
    static std::map<Key, cv::Mat> all;
    cv::Mat& picture =
        all[{GetParam().yard, GetParam().light, GetParam().simulator, options.shadow_map_size,
             options.samples, view.X_WC.translation().y(), time}];
    if (picture.empty()) {
      move(time);
      Renderer renderer(description, stage.links(), options);
      picture = draw(renderer);
    }
    return picture;
  }

  void expectAsDrawnAnew(const std::vector<cv::Mat>& pictures) {
    for (int time = 0; time < static_cast<int>(pictures.size()); ++time) {
      const cv::Mat& picture = pictures[static_cast<std::size_t>(time)];
      EXPECT_EQ(cv::norm(picture, drawnAnew(time), cv::NORM_INF), 0.0) << "time " << time;
    }
  }

  RenderOptions options;
  world::Description description;
  Stage stage;
  View view{CameraModel(320, 240, {260.0, 260.0, 159.5, 119.5}, 0.05, 100.0), {}};
};

TEST_P(KeptPictures, AreThoseThatAreDrawnAnew) {
  std::vector<cv::Mat> pictures;
  {
    Renderer renderer(description, stage.links(), options);
    for (int time = 0; time < 7; ++time) {
      move(time);
      pictures.push_back(draw(renderer));
    }
  }
  EXPECT_GT(cv::norm(pictures[4], pictures[5], cv::NORM_INF), 20.0) << "something moves";
  expectAsDrawnAnew(pictures);
}

/// As for a rolling shutter, some rows are drawn, then the world and maybe the camera move.
TEST_P(KeptPictures, HaveTheRowsOfWholePictures) {
  const Pose X_WC = view.X_WC;
  for (const double step : {0.0, 0.02}) {
    const auto moveTo = [&](int time) {
      move(time);
      view.X_WC = X_WC;
      view.X_WC.translation().y() += step * time;
    };
    const cv::Rect image(0, 0, 320, 240);
    const auto rowsAt = [&](int time) {
      return cv::Rect(0, 50 * (time % 4) + 12, 320, 50) & image;
    };
    std::vector<cv::Mat> bands;
    std::vector<cv::Mat> items;
    {
      Renderer renderer(description, stage.links(), options);
      for (int time = 0; time < 8; ++time) {
        moveTo(time);
        ColourPass pass{stage.all(), stage.all()};
        pass.regions = {rowsAt(time)};
        bands.push_back(renderer.colour(view, stage.poses(), pass)(rowsAt(time)).clone());
        if (time % 3 == 0) {
          items.push_back(renderer.labels(view, stage.poses(), {stage.all()}).ids.clone());
        }
      }
    }
    for (int time = 0; time < 8; ++time) {
      moveTo(time);
      const auto at = static_cast<std::size_t>(time);
      EXPECT_EQ(cv::norm(bands[at], drawnAnew(time)(rowsAt(time)), cv::NORM_INF), 0.0) << time;
      if (time % 3 != 0) continue;
      Renderer renderer(description, stage.links(), options);
      const LabelImages labels = renderer.labels(view, stage.poses(), {stage.all()});
      EXPECT_EQ(cv::norm(items[at / 3], labels.ids, cv::NORM_INF), 0.0) << time;
    }
  }
}

TEST_P(KeptPictures, HaveTheBlurredRimsOfShadowsToo) {
  options.shadow_map_size = 128;
  options.samples = 1;
  std::vector<cv::Mat> pictures;
  {
    Renderer renderer(description, stage.links(), options);
    for (int time = 0; time < 5; ++time) {
      move(time);
      pictures.push_back(draw(renderer));
    }
  }
  expectAsDrawnAnew(pictures);
}

TEST_P(KeptPictures, HaveTheEdgesOfWhatStandsJustBesideARegion) {
  constexpr int kRows = 4;
  std::vector<cv::Mat> pictures;
  {
    Renderer renderer(description, stage.links(), options);
    for (int time = 0; time < 3; ++time) {
      move(time);
      cv::Mat picture = draw(renderer);
      for (int row = 60; row < 160; row += kRows) {
        const cv::Rect band(0, row, picture.cols, kRows);
        renderer
            .colour(view, stage.poses(),
                    {stage.all(), stage.all(), Sampling::kSmooth, {band}})(band)
            .copyTo(picture(band));
      }
      pictures.push_back(picture);
    }
  }
  expectAsDrawnAnew(pictures);
}

TEST_P(KeptPictures, AreFinishedInAnyOrderAndThread) {
  std::vector<cv::Mat> pictures(5);
  {
    Renderer renderer(description, stage.links(), options);
    std::vector<PendingPicture> pending;
    for (int time = 0; time < 5; ++time) {
      move(time);
      pending.push_back(renderer.draw(view, stage.poses(), {stage.all(), stage.all()}));
    }
    std::thread other([&] {
      for (const std::size_t time : {4U, 1U}) pictures[time] = pending[time]();
    });
    for (const std::size_t time : {3U, 0U, 2U}) pictures[time] = pending[time]();
    other.join();
  }
  expectAsDrawnAnew(pictures);
}

TEST_P(KeptPictures, OfRegionsAreThoseThatAreDrawnAnew) {
  // As for masks by background subtraction: the background in the objects' boxes, then one object.
  const LinkSelection none(stage.all().size(), false);
  LinkSelection background = stage.all();
  for (std::size_t moving = kBall; moving < background.size(); ++moving) background[moving] = false;
  LinkSelection ball = background;
  ball[kBall] = true;
  const cv::Rect region(100, 80, 120, 100);
  const auto drawAll = [&](Renderer& renderer) {
    std::vector<PendingPicture> pending = {
        renderer.draw(view, stage.poses(), {stage.all(), stage.all()})};
    for (const LinkSelection& drawn : {background, ball, background}) {
      pending.push_back(
          renderer.draw(view, stage.poses(), {drawn, none, Sampling::kCentre, {region}}));
    }
    std::vector<cv::Mat> pictures;
    for (const PendingPicture& finish : pending) pictures.push_back(finish());
    for (std::size_t i = 1; i < pictures.size(); ++i) pictures[i] = pictures[i](region);
    return pictures;
  };
  const auto drawTimes = [&](bool reuse) {
    options.reuse = reuse;
    Renderer renderer(description, stage.links(), options);
    std::vector<cv::Mat> pictures;
    for (int time = 0; time < 3; ++time) {
      move(time);
      const std::vector<cv::Mat> those = drawAll(renderer);
      pictures.insert(pictures.end(), those.begin(), those.end());
    }
    return pictures;
  };
  const std::vector<cv::Mat> pictures = drawTimes(true);
  const std::vector<cv::Mat> expected = drawTimes(false);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    EXPECT_EQ(cv::norm(pictures[i], expected[i], cv::NORM_INF), 0.0) << i;
  }
}

std::string nameOf(const testing::TestParamInfo<Case>& each) {
  const std::string detail = each.param.light == LightDetail::kFull ? "_in_full_light" : "";
  const std::string light =
      detail + (each.param.simulator == world::Simulator::kGz ? "_of_gz_sim" : "");
  switch (each.param.yard) {
    case Yard::kWithGlass:
      return "with_glass" + light;
    case Yard::kWithoutGlass:
      return "without_glass" + light;
    case Yard::kThroughALens:
      return "through_a_lens" + light;
    case Yard::kSkyThroughALens:
      return "sky_through_a_lens" + light;
  }
  return "";
}

INSTANTIATE_TEST_SUITE_P(
    Yards, KeptPictures,
    testing::Values(Case{Yard::kWithGlass}, Case{Yard::kWithoutGlass}, Case{Yard::kThroughALens},
                    Case{Yard::kWithGlass, LightDetail::kFull},
                    Case{Yard::kThroughALens, LightDetail::kFull},
                    Case{Yard::kWithoutGlass, LightDetail::kFull, world::Simulator::kGz},
                    Case{Yard::kSkyThroughALens, LightDetail::kFull, world::Simulator::kGz}),
    nameOf);

TEST(KeptPicturesOfAnAisle, HaveTheShadowsOfASunWhoseMapIsNotSquare) {
  world::Description description;
  description.ambient = {0.3F, 0.3F, 0.3F};
  world::Light sun;
  sun.casts_shadow = true;
  sun.direction_L = Eigen::Vector3d(0.0, 0.5, -0.86).normalized();  // across the aisle
  description.lights = {sun};
  Stage stage;
  stage.addBox({30, 1.6, 0.2}, at(0, 0, -0.1), -1, coloured(0.8F, 0.8F, 0.7F));
  stage.addBox({30, 0.1, 1.5}, at(0, 0.85, 0.75), -1, coloured(0.7F, 0.4F, 0.3F));
  stage.addBox({0.2, 0.2, 1.0}, at(0, 0.5, 0.5), 0, coloured(0.2F, 0.2F, 0.9F));
  Eigen::Matrix3d R_WC;  // along +y
  R_WC << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  const View view{CameraModel(320, 240, {400.0, 400.0, 159.5, 119.5}, 0.05, 100.0),
                  makePose({0.5, -0.7, 0.4}, Eigen::Quaterniond(R_WC))};
  RenderOptions options;
  options.samples = 1;
  const auto move = [&](int time) { stage.poses()[2] = at(0.03 * time, 0.5, 0.5); };
  const auto draw = [&](Renderer& renderer) {
    return renderer.colour(view, stage.poses(), {stage.all(), stage.all()});
  };
  std::vector<cv::Mat> pictures;
  {
    Renderer renderer(description, stage.links(), options);
    for (int time = 0; time < 5; ++time) {
      move(time);
      pictures.push_back(draw(renderer));
    }
  }
  EXPECT_GT(cv::norm(pictures[3], pictures[4], cv::NORM_INF), 20.0) << "something moves";
  for (int time = 0; time < 5; ++time) {
    move(time);
    Renderer renderer(description, stage.links(), options);
    EXPECT_EQ(cv::norm(pictures[static_cast<std::size_t>(time)], draw(renderer), cv::NORM_INF), 0.0)
        << "time " << time;
  }
}

TEST_P(KeptPictures, OfNoPixelsAreBackground) {
  Renderer renderer(description, stage.links(), options);
  for (int time = 0; time < 3; ++time) {
    move(time);
    const cv::Mat picture = renderer.colour(
        view, stage.poses(), {stage.all(), stage.all(), Sampling::kCentre, {cv::Rect()}});
    ASSERT_EQ(picture.size(), cv::Size(320, 240));
    const cv::Mat plain(picture.size(), CV_8UC3, picture.at<cv::Vec3b>(0, 0));
    EXPECT_EQ(cv::norm(picture, plain, cv::NORM_INF), 0.0);
  }
}

TEST_P(KeptPictures, AreThoseOfSeveralCamerasToo) {
  std::vector<cv::Mat> pictures;
  {
    Renderer renderer(description, stage.links(), options);
    for (int time = 0; time < 7; ++time) {
      move(time);
      for (int camera = 1; camera < 4; ++camera) {
        const View other{view.camera, view.X_WC * at(0.1 * camera, 0, 0)};
        (void)renderer.colour(other, stage.poses(), {stage.all(), stage.all()});
        (void)renderer.labels(other, stage.poses(), {stage.all()});
      }
      const View moving{view.camera, view.X_WC * at(0, 0.1 * time, 0)};
      (void)renderer.colour(moving, stage.poses(), {stage.all(), stage.all()});
      pictures.push_back(draw(renderer));
    }
  }
  expectAsDrawnAnew(pictures);
}

TEST_P(KeptPictures, AreNotMixedUpWithOthers) {
  std::vector<cv::Mat> pictures;
  {
    Renderer renderer(description, stage.links(), options);
    const View elsewhere{view.camera, view.X_WC * at(0.3, 0, 0)};
    const cv::Rect region(10, 10, 100, 100);
    for (int time = 0; time < 6; ++time) {
      move(time);
      if (time % 3 == 2)
        (void)renderer.colour(elsewhere, stage.poses(), {stage.all(), stage.all()});
      LinkSelection fewer = stage.all();
      fewer[0] = false;
      fewer[kBall] = false;
      (void)renderer.colour(view, stage.poses(), {fewer, fewer, Sampling::kSmooth, {region}});
      (void)renderer.colour(view, stage.poses(), {stage.all(), fewer, Sampling::kCentre});
      (void)renderer.labels(view, stage.poses(), {stage.all()});
      pictures.push_back(draw(renderer));
    }
  }
  expectAsDrawnAnew(pictures);
}

}  // namespace picture_painter_test
}  // namespace synthetic_dataset::render
