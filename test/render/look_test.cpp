/// Worlds that are relit and repainted, against worlds that were described so from the start.

#include <array>
#include <functional>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/picture_taking.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::render {
namespace look_test {

using test::halvedTexture;
using test::Stage;

enum Thing : std::size_t { kFloor, kWall, kColumn, kPane, kFence, kBall, kCup, kThings };

Pose at(double x, double y, double z) {
  return makePose({x, y, z}, Eigen::Quaterniond::Identity());
}

world::Material coloured(float red, float green, float blue, float alpha = 1.0F) {
  world::Material material;
  material.diffuse = {red, green, blue, alpha};
  return material;
}

/// A yard with a sun and a lamp: a wall with a texture, a column with a normal map, a pane of glass
/// and a fence with holes stand in it; a ball that glows and a cup of glass move.
struct Yard {
  Yard() {
    description.ambient = {0.3F, 0.3F, 0.3F};
    description.background = {0.2F, 0.5F, 0.8F};
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
    description.lights = {sun, lamp};
    paint[kFloor] = coloured(0.8F, 0.8F, 0.7F);
    paint[kWall] = coloured(0.9F, 0.8F, 0.7F);
    paint[kWall].texture = halvedTexture({40, 90, 200, 255}, {200, 200, 200, 255});
    paint[kColumn] = coloured(0.3F, 0.6F, 0.3F);
    paint[kColumn].normal_map = halvedTexture({255, 128, 128, 255}, {200, 128, 200, 255});
    paint[kPane] = coloured(0.5F, 0.7F, 0.9F, 0.4F);
    paint[kFence] = coloured(0.5F, 0.4F, 0.2F);
    paint[kFence].texture = halvedTexture({255, 255, 255, 255}, {255, 255, 255, 0});
    paint[kBall] = coloured(0.9F, 0.2F, 0.2F);
    paint[kBall].emissive = {0.4F, 0.4F, 0.4F};
    paint[kBall].emissive_map = halvedTexture({0, 200, 0, 255}, {0, 0, 0, 255});
    paint[kCup] = coloured(0.9F, 0.9F, 0.9F, 0.5F);
  }

  [[nodiscard]] Stage stage() const {
    Stage stage;
    stage.addBox({8, 8, 0.2}, at(0, 0, -0.1), -1, paint[kFloor]);
    stage.addBox({0.2, 6, 1.5}, at(2, 0, 0.75), -1, paint[kWall]);
    stage.addBox({0.4, 0.4, 0.6}, at(-0.5, 1, 0.3), -1, paint[kColumn]);
    stage.addBox({0.02, 1, 1}, at(0.5, -1, 0.5), -1, paint[kPane]);
    stage.addBox({0.05, 0.6, 0.6}, at(-1.0, -0.6, 0.3), -1, paint[kFence]);
    stage.addMesh(world::sphereMesh(0.3), at(0, 0, 0.3), 0, paint[kBall]);
    stage.addBox({0.3, 0.3, 0.3}, at(-1, 0.2, 0.15), 1, paint[kCup]);
    return stage;
  }

  world::Description description;
  std::array<world::Material, kThings> paint;
};

/// The same yard on another day: its lights elsewhere and of other colours, all things repainted.
Yard repainted() {
  Yard yard;
  yard.description.ambient = {0.5F, 0.3F, 0.2F};
  yard.description.background = {0.9F, 0.4F, 0.1F};
  world::Light& sun = yard.description.lights[0];
  sun.diffuse = {1.5F, 1.0F, 0.5F};
  sun.direction_L = Eigen::Vector3d(0.3, -0.8, -0.7).normalized();
  world::Light& lamp = yard.description.lights[1];
  lamp.diffuse = {0.2F, 0.9F, 0.4F};
  lamp.X_WL = at(0.2, -0.5, 2.0);
  yard.paint[kFloor].diffuse = {0.3F, 0.2F, 0.6F, 1.0F};
  yard.paint[kFloor].roughness = 0.2F;
  yard.paint[kWall].diffuse = {0.4F, 0.9F, 0.9F, 1.0F};
  yard.paint[kColumn].metalness = 1.0F;
  yard.paint[kColumn].emissive = {0.1F, 0.0F, 0.2F};
  yard.paint[kPane].diffuse = {0.9F, 0.1F, 0.1F, 0.4F};
  yard.paint[kFence].diffuse = {0.9F, 0.9F, 0.1F, 1.0F};
  yard.paint[kBall].specular = {0.9F, 0.9F, 0.9F};
  yard.paint[kBall].roughness = 0.3F;
  yard.paint[kCup].diffuse = {0.1F, 0.8F, 0.2F, 0.5F};
  return yard;
}

class Looks : public testing::Test {
 protected:
  Looks() {
    options.shadow_map_size = 512;
    Eigen::Matrix3d R_WC;  // along +x, a little downwards
    R_WC << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    view.X_WC = makePose(
        {-3, 0, 1.2}, Eigen::Quaterniond(R_WC) * Eigen::AngleAxisd(-0.2, Eigen::Vector3d::UnitX()));
  }

  /// The look that makes a renderer's own yard look like another one.
  [[nodiscard]] world::Look lookOf(const Yard& yard) const {
    world::Look look(yard.description);
    for (std::size_t thing = 0; thing < kThings; ++thing) {
      look.materials[&stage.links()[thing].link->visuals[0].surfaces[0].material] =
          yard.paint[thing];
    }
    return look;
  }

  [[nodiscard]] std::unique_ptr<Renderer> makeRenderer() const {
    return std::make_unique<Renderer>(original.description, stage.links(), options);
  }

  [[nodiscard]] cv::Mat draw(Renderer& renderer) const {
    return renderer.colour(view, stage.poses(), {stage.all(), stage.all()});
  }

  /// One picture by a renderer that was given the looks of these yards one after the other.
  [[nodiscard]] cv::Mat drawWearing(const std::vector<Yard>& yards) const {
    const auto renderer = makeRenderer();
    for (const Yard& yard : yards) renderer->setLook(lookOf(yard));
    return draw(*renderer);
  }

  /// One picture by a new renderer that knows only this yard, with things where they are now.
  [[nodiscard]] cv::Mat drawAnew(const Yard& yard) const {
    Stage anew = yard.stage();
    anew.poses() = stage.poses();
    Renderer renderer(yard.description, anew.links(), options);
    return draw(renderer);
  }

  void expectAsDescribed(const Yard& yard) const {
    const cv::Mat expected = drawAnew(yard);
    EXPECT_GT(cv::norm(expected, drawAnew(original), cv::NORM_INF), 20.0) << "it looks different";
    EXPECT_EQ(cv::norm(drawWearing({yard}), expected, cv::NORM_INF), 0.0);
  }

  void move(int time) {
    const double t = 0.1 * time;
    stage.poses()[kBall] = at(0.5 * std::sin(3 * t), std::cos(2 * t), 0.3 + 0.2 * t);
    stage.poses()[kCup] = at(-1, t - 0.5, 0.15);
  }

  /// Compares pictures, each in a look of its own, of things that move before a static camera.
  void expectKeptPicturesAsDescribed(const std::vector<Yard>& looks) {
    std::vector<cv::Mat> pictures;
    {
      const auto renderer = makeRenderer();
      for (std::size_t time = 0; time < looks.size(); ++time) {
        move(static_cast<int>(time));
        renderer->setLook(lookOf(looks[time]));
        pictures.push_back(draw(*renderer));
      }
    }
    for (std::size_t time = 0; time < looks.size(); ++time) {
      move(static_cast<int>(time));
      EXPECT_EQ(cv::norm(pictures[time], drawAnew(looks[time]), cv::NORM_INF), 0.0) << time;
    }
  }

  const Yard original;
  Stage stage = original.stage();
  RenderOptions options;
  View view{CameraModel(160, 120, {130.0, 130.0, 79.5, 59.5}, 0.05, 100.0), {}};
};

TEST_F(Looks, AreThoseOfADescriptionThatHasTheirLights) {
  Yard yard;
  yard.description.lights[0].diffuse = {0.3F, 0.9F, 1.8F};
  yard.description.lights[1].diffuse.setZero();
  expectAsDescribed(yard);
}

TEST_F(Looks, MoveShadowsWithTheirLights) {
  Yard yard;
  yard.description.lights[0].direction_L = Eigen::Vector3d(0.3, -0.8, -0.7).normalized();
  yard.description.lights[1].X_WL = at(0.2, -0.5, 2.0);
  expectAsDescribed(yard);
}

TEST_F(Looks, HaveAnAmbientLightAndABackground) {
  Yard yard;
  yard.description.ambient = {0.7F, 0.2F, 0.2F};
  yard.description.background = {0.9F, 0.4F, 0.1F};
  expectAsDescribed(yard);
}

TEST_F(Looks, RepaintWhatIsSolidAndWhatOneCanSeeThrough) {
  Yard yard;
  yard.paint = repainted().paint;
  expectAsDescribed(yard);
}

TEST_F(Looks, RepaintOneThingAlone) {
  Yard yard;
  yard.paint[kColumn].diffuse = {0.9F, 0.1F, 0.9F, 1.0F};
  const auto& material = stage.links()[kColumn].link->visuals[0].surfaces[0].material;
  world::Look look(original.description);
  look.materials[&material] = yard.paint[kColumn];
  cv::Mat picture;
  {
    const auto renderer = makeRenderer();
    renderer->setLook(look);
    picture = draw(*renderer);
  }
  EXPECT_EQ(cv::norm(picture, drawAnew(yard), cv::NORM_INF), 0.0);
}

TEST_F(Looks, PutTexturesOnAndTakeThemOff) {
  Yard dotted;
  dotted.paint[kFloor].texture = halvedTexture({10, 200, 90, 255}, {220, 30, 120, 255});
  dotted.paint[kBall].texture = halvedTexture({0, 0, 0, 255}, {255, 255, 255, 255});
  dotted.paint[kWall].texture = halvedTexture({0, 255, 255, 255}, {0, 60, 0, 255});
  expectAsDescribed(dotted);
  Yard bare;
  bare.paint[kWall].texture = nullptr;
  EXPECT_EQ(cv::norm(drawWearing({dotted, bare}), drawAnew(bare), cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(drawWearing({bare, original}), drawAnew(original), cv::NORM_INF), 0.0);
}

TEST_F(Looks, PutMapsOnAndTakeThemOff) {
  Yard yard;
  const auto picture = halvedTexture({10, 200, 90, 255}, {220, 30, 120, 255});
  yard.paint[kFloor].texture = picture;
  yard.paint[kWall].roughness_map = picture;
  yard.paint[kFloor].metalness = 1.0F;
  yard.paint[kFloor].metalness_map = picture;
  yard.paint[kColumn].normal_map = nullptr;
  yard.paint[kBall].emissive_map = nullptr;
  expectAsDescribed(yard);
}

/// Here the renderer is the only other owner of the textures.
TEST_F(Looks, LeaveTheWorldItsOwnTextures) {
  const Stage lone = Yard().stage();
  Renderer renderer(original.description, lone.links(), options);
  const cv::Mat before = draw(renderer);
  for (int i = 0; i < 2; ++i) {
    renderer.setLook(world::Look(original.description));
    EXPECT_EQ(cv::norm(draw(renderer), before, cv::NORM_INF), 0.0) << i;
  }
}

TEST_F(Looks, OfTheDescriptionAloneChangeNothing) {
  const cv::Mat expected = drawAnew(original);
  const auto renderer = makeRenderer();
  EXPECT_EQ(cv::norm(draw(*renderer), expected, cv::NORM_INF), 0.0);
  for (int i = 0; i < 3; ++i) {
    renderer->setLook(world::Look(original.description));
    EXPECT_EQ(cv::norm(draw(*renderer), expected, cv::NORM_INF), 0.0) << i;
  }
  renderer->setLook(lookOf(repainted()));
  (void)draw(*renderer);
  renderer->setLook(world::Look(original.description));
  EXPECT_EQ(cv::norm(draw(*renderer), expected, cv::NORM_INF), 0.0);
}

TEST_F(Looks, MoveTheSunOfTheSky) {
  Yard under_sky;
  under_sky.description.sky = world::Sky();
  const cv::Mat before = drawAnew(under_sky);
  world::Look look(under_sky.description);
  look.lights[0].direction_L = Eigen::Vector3d(-1.0, 0.1, -0.25).normalized();
  cv::Mat found;
  {
    Renderer renderer(under_sky.description, stage.links(), options);
    renderer.setLook(look);
    found = draw(renderer);
  }
  under_sky.description.lights = look.lights;
  EXPECT_EQ(cv::norm(found, drawAnew(under_sky), cv::NORM_INF), 0.0);
  const cv::Rect sky(0, 0, 160, 10);
  EXPECT_GT(cv::norm(found(sky), before(sky), cv::NORM_INF), 10.0) << "the sky is another";
}

TEST_F(Looks, AreSeenThroughALensToo) {
  view.camera = CameraModel(160, 120, {100.0, 100.0, 79.5, 59.5}, 0.05, 100.0,
                            {DistortionModel::kPlumbBob, {-0.2, 0.05, 0.0, 0.0, 0.0}});
  expectAsDescribed(repainted());
}

TEST_F(Looks, MultiplyWithTheExposure) {
  const Yard yard = repainted();
  const auto drawExposed = [&](Renderer& renderer) {
    ColourPass pass{stage.all(), stage.all()};
    pass.exposure = 1.7F;
    return renderer.colour(view, stage.poses(), pass);
  };
  cv::Mat found;
  {
    const auto renderer = makeRenderer();
    renderer->setLook(lookOf(yard));
    found = drawExposed(*renderer);
  }
  const Stage anew = yard.stage();
  Renderer renderer(yard.description, anew.links(), options);
  EXPECT_EQ(cv::norm(found, drawExposed(renderer), cv::NORM_INF), 0.0);
}

/// From the third picture on, most pixels are kept from the picture before.
TEST_F(Looks, CountForKeptPictures) {
  const Yard a;
  const Yard b = repainted();
  expectKeptPicturesAsDescribed({a, a, a, a, b, b, b, a, b});
}

TEST_F(Looks, CountWhereNothingIsKept) {
  options.reuse = false;
  const Yard a;
  const Yard b = repainted();
  expectKeptPicturesAsDescribed({a, a, b, b, a});
}

/// Draws several pictures in each look: pixels kept in one look do not show in the next.
TEST_F(Looks, DoNotShowWhatWasKeptOfOthers) {
  constexpr int kTimes = 4;
  const std::array<Yard, 2> yards = {original, repainted()};
  std::vector<cv::Mat> pictures;
  {
    const auto renderer = makeRenderer();
    for (const std::size_t yard : {0U, 1U, 0U, 1U}) {
      renderer->setLook(lookOf(yards[yard]));
      for (int time = 0; time < kTimes; ++time) {
        move(time);
        (void)renderer->labels(view, stage.poses(), {stage.all()});
        pictures.push_back(draw(*renderer));
      }
    }
  }
  for (std::size_t i = 0; i < 2 * kTimes; ++i) {
    move(static_cast<int>(i % kTimes));
    const cv::Mat expected = drawAnew(yards[i / kTimes]);
    EXPECT_EQ(cv::norm(pictures[i], expected, cv::NORM_INF), 0.0) << i;
    EXPECT_EQ(cv::norm(pictures[i + 2 * kTimes], expected, cv::NORM_INF), 0.0) << i << " again";
  }
}

/// Another thread may finish a picture while the next look is already set.
TEST_F(Looks, LeaveAloneWhatWasDrawnBefore) {
  cv::Mat picture;
  {
    const auto renderer = makeRenderer();
    const PendingPicture pending = renderer->draw(view, stage.poses(), {stage.all(), stage.all()});
    Yard yard = repainted();
    yard.paint[kFloor].texture = halvedTexture({10, 200, 90, 255}, {220, 30, 120, 255});
    renderer->setLook(lookOf(yard));
    (void)draw(*renderer);
    picture = pending();
  }
  EXPECT_EQ(cv::norm(picture, drawAnew(original), cv::NORM_INF), 0.0);
}

TEST_F(Looks, ChangeNeitherLabelsNorDepthNorSilhouettes) {
  const auto renderer = makeRenderer();
  const LabelPass pass{stage.all()};
  const LabelImages before = renderer->labels(view, stage.poses(), pass);
  LinkSelection cup(stage.links().size(), false);
  cup[kCup] = true;
  const cv::Mat outline = renderer->silhouette(view, stage.poses(), cup).mask.whole();
  const cv::Rect reach = renderer->reach(view, stage.poses(), cup);
  ASSERT_GT(cv::countNonZero(before.ids == 1), 50) << "the ball is seen";
  Yard yard = repainted();
  yard.paint[kBall].texture = halvedTexture({10, 200, 90, 255}, {220, 30, 120, 255});

  renderer->setLook(lookOf(yard));
  (void)draw(*renderer);

  const LabelImages after = renderer->labels(view, stage.poses(), pass);
  EXPECT_EQ(cv::norm(before.ids, after.ids, cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(before.depth, after.depth, cv::NORM_INF), 0.0);
  EXPECT_EQ(
      cv::norm(outline, renderer->silhouette(view, stage.poses(), cup).mask.whole(), cv::NORM_INF),
      0.0);
  EXPECT_EQ(reach, renderer->reach(view, stage.poses(), cup));
}

TEST_F(Looks, AreCounted) {
  const auto renderer = makeRenderer();
  const std::int64_t before = renderer->lookRevision();
  (void)draw(*renderer);
  EXPECT_EQ(renderer->lookRevision(), before);
  renderer->setLook(lookOf(original));
  EXPECT_GT(renderer->lookRevision(), before);
}

TEST_F(Looks, LetGoOfTexturesThatAreWornNoMore) {
  const auto renderer = makeRenderer();
  std::weak_ptr<const world::Texture> worn;
  {
    Yard yard;
    yard.paint[kFloor].texture = halvedTexture({10, 200, 90, 255}, {220, 30, 120, 255});
    yard.paint[kBall].texture = yard.paint[kFloor].texture;
    yard.paint[kBall].roughness_map = yard.paint[kFloor].texture;
    worn = yard.paint[kFloor].texture;
    renderer->setLook(lookOf(yard));
  }
  (void)draw(*renderer);
  EXPECT_FALSE(worn.expired());
  renderer->setLook(lookOf(original));
  EXPECT_TRUE(worn.expired());
}

}  // namespace look_test
}  // namespace synthetic_dataset::render
