#include "render/geometry/silhouette_bits.h"

#include <random>

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include "render/gl/offscreen_context.h"
#include "render/picture_taking.h"
#include "render/renderer.h"
#include "support/box_world.h"
#include "support/random_poses.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::render {
namespace silhouette_bits_test {

using test::Stage;

const View kView{CameraModel(320, 240, {260.0, 260.0, 159.5, 119.5}, 0.05, 100.0),
                 Pose::Identity()};

Pose at(double x, double y, double z) {
  return makePose({x, y, z}, Eigen::Quaterniond::Identity());
}

/// The bits that the objects of a stage, of one link each, set.
std::vector<int> bitsOf(const Stage& stage) {
  const OffscreenContext context;
  const DrawList draw_list(context.gl(), stage.links(), world::Simulator::kGz);
  const SilhouetteBits bits(draw_list, kView, stage.poses(), stage.all());
  std::vector<int> result;
  for (const DrawItem& item : draw_list.items()) result.push_back(bits.of(item));
  return result;
}

TEST(SilhouetteBits, AreSharedByObjectsThatAreApart) {
  Stage stage;
  int object = 0;
  for (const double x : {-0.5, -0.45, 0.5}) stage.addBox({0.1, 0.1, 0.1}, at(x, 0, 2), object++);
  stage.addBox({9, 9, 0.1}, at(0, 0, 5));
  EXPECT_THAT(bitsOf(stage), testing::ElementsAre(1, 2, 1, 0));
}

TEST(SilhouetteBits, AreEightAtAPlace) {
  Stage stage;
  for (int i = 0; i < 10; ++i) stage.addBox({0.1, 0.1, 0.1}, at(0, 0, 2), i);
  EXPECT_THAT(bitsOf(stage), testing::ElementsAre(1, 2, 4, 8, 16, 32, 64, 128, 0, 0));
}

TEST(SilhouetteBits, AreOfNoObjectThatOneCanSeeThroughAndOfNoneBesideTheImage) {
  world::Material glass;
  glass.diffuse.w() = 0.5F;
  Stage stage;
  stage.addBox({0.1, 0.1, 0.1}, at(0, 0, 2), 0, glass);
  stage.addBox({0.1, 0.1, 0.1}, at(0, 0, -2), 1);
  EXPECT_THAT(bitsOf(stage), testing::ElementsAre(0, 0));
}

/// Objects in a heap, more than there are bits for, behind a pole: some partly out of the picture,
/// one of glass, one that is seen from both sides, one with holes, one of two links.
class Heap : public testing::Test {
 protected:
  static constexpr int kObjects = 14;
  static constexpr int kOfTwoLinks = 1;  ///< its second link comes after all objects' first links

  Heap() {
    world::Material glass;
    glass.diffuse.w() = 0.5F;
    world::Material paper;
    paper.double_sided = true;
    world::Material sieve;
    sieve.texture = test::halvedTexture({0, 0, 0, 0}, {0, 0, 0, 255});
    sieve.alpha_threshold = 0.5F;
    for (int i = 0; i < kObjects; ++i) {
      if (i % 2 == 0) {
        stage.addMesh(world::sphereMesh(0.25), {}, i, i == 4 ? glass : world::Material());
      } else {
        stage.addBox({0.3, 0.2, 0.4}, {}, i, i == 5 ? paper : i == 7 ? sieve : world::Material());
      }
    }
    stage.addBox({0.2, 0.1, 0.2}, {}, kOfTwoLinks);
    stage.addBox({0.1, 3, 0.1}, at(0, 0, 1.2));
  }

  /// Moves the objects to where they are at a time.
  void move(unsigned time) {
    std::mt19937 random(time);
    for (int i = 0; i <= kObjects; ++i) {
      Eigen::Vector3d place = test::randomPoint(random, 1.5);
      place.z() = 2.5 + 0.5 * place.z();
      stage.poses()[static_cast<std::size_t>(i)] = makePose(place, test::randomOrientation(random));
    }
  }

  /// Selects the links of one object.
  [[nodiscard]] LinkSelection linksOf(int object) const {
    LinkSelection links(stage.poses().size(), false);
    links[static_cast<std::size_t>(object)] = true;
    if (object == kOfTwoLinks) links[kObjects] = true;
    return links;
  }

  [[nodiscard]] std::vector<Silhouette> silhouettes(Renderer& renderer) const {
    std::vector<Silhouette> all;
    for (int i = 0; i < kObjects; ++i) {
      all.push_back(renderer.silhouette(kView, stage.poses(), linksOf(i)));
    }
    return all;
  }

  void expectSame(const std::vector<Silhouette>& found, const std::vector<Silhouette>& wanted) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_EQ(cv::norm(found[i].mask.whole(), wanted[i].mask.whole(), cv::NORM_INF), 0.0)
          << "object " << i;
      EXPECT_EQ(found[i].pixels, wanted[i].pixels);
      EXPECT_EQ(found[i].pixels_in_image, wanted[i].pixels_in_image);
      ASSERT_EQ(found[i].box.has_value(), wanted[i].box.has_value());
      if (!wanted[i].box) continue;
      EXPECT_EQ(found[i].box->left, wanted[i].box->left);
      EXPECT_EQ(found[i].box->top, wanted[i].box->top);
      EXPECT_EQ(found[i].box->right, wanted[i].box->right);
      EXPECT_EQ(found[i].box->bottom, wanted[i].box->bottom);
    }
  }

  Stage stage;
};

TEST_F(Heap, HasTheSilhouettesThatEachOfItHasAlone) {
  constexpr unsigned kTimes = 6;
  std::vector<std::vector<Silhouette>> found;
  {
    Renderer renderer({}, stage.links(), {});
    for (unsigned time = 0; time < kTimes; ++time) {
      move(time);
      // Glass needs labels of its own; what is drawn without it is what silhouettes are told of.
      LinkSelection drawn = stage.all();
      drawn[4] = time % 2 == 0;
      drawn[kObjects] = time % 3 != 0;
      (void)renderer.labels(kView, stage.poses(), {drawn});
      (void)renderer.colour(kView, stage.poses(), {drawn, drawn});
      found.push_back(silhouettes(renderer));
    }
  }
  Renderer alone({}, stage.links(), {});
  for (unsigned time = 0; time < kTimes; ++time) {
    move(time);
    const std::vector<Silhouette> wanted = silhouettes(alone);
    expectSame(found[time], wanted);
  }
}

TEST_F(Heap, HasThemAlsoWhereOtherThingsWereDrawn) {
  move(7);
  Renderer renderer({}, stage.links(), {});
  const std::vector<Silhouette> wanted = silhouettes(renderer);
  const auto expectAfterDrawing = [&](const LinkSelection& drawn) {
    (void)renderer.labels(kView, stage.poses(), {drawn});
    expectSame(silhouettes(renderer), wanted);
  };
  LinkSelection some = stage.all();
  for (const std::size_t missing : {1, 4, 7}) some[missing] = false;
  expectAfterDrawing(some);
  expectAfterDrawing(linksOf(3));
  const std::vector<Pose> poses = stage.poses();
  move(8);
  (void)renderer.labels(kView, stage.poses(), {some});
  stage.poses() = poses;
  expectSame(silhouettes(renderer), wanted);
}

}  // namespace silhouette_bits_test
}  // namespace synthetic_dataset::render
