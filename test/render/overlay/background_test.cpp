/// Pictures behind the world.

#include <cmath>
#include <cstdint>
#include <functional>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/lens_cases.h"
#include "render/overlay/background_painter.h"
#include "render/picture_taking.h"
#include "render/pixels/srgb.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::render {
namespace background_test {

using synthetic_dataset::test::kSmallCamera;
using synthetic_dataset::test::Stage;
using Projection = world::BackgroundPicture::Projection;

constexpr double kPi = 3.14159265358979;

/// A picture of independent random pixels.
cv::Mat noise(const cv::Size& size, std::uint64_t seed = 1) {
  cv::Mat pixels(size, CV_8UC4);
  cv::RNG(seed).fill(pixels, cv::RNG::UNIFORM, 0, 256);
  pixels |= cv::Scalar(0, 0, 0, 255);
  return pixels;
}

cv::Mat withoutAlpha(const cv::Mat& picture) {
  cv::Mat result(picture.size(), CV_8UC3);
  cv::mixChannels({picture}, {result}, {0, 0, 1, 1, 2, 2});
  return result;
}

cv::Mat plain(const cv::Size& size, const cv::Scalar& pixel) { return {size, CV_8UC4, pixel}; }

world::BackgroundPicture behind(const cv::Mat& pixels, Projection projection) {
  world::BackgroundPicture picture;
  picture.picture = std::make_shared<world::Texture>(world::Texture{"picture", pixels});
  picture.projection = projection;
  return picture;
}

world::Look lookWith(const world::Description& description, const cv::Mat& pixels,
                     Projection projection = Projection::kBackdrop) {
  world::Look look(description);
  look.background_picture = behind(pixels, projection);
  return look;
}

/// A picture of the background only.
cv::Mat seenWith(const world::Look& look, const View& view = {kSmallCamera},
                 Sampling sampling = Sampling::kSmooth, float exposure = 1.0F) {
  Renderer renderer(test::dark(), {}, {});
  renderer.setLook(look);
  return renderer.colour(view, {}, {{}, {}, sampling, {}, exposure});
}

/// The greatest difference, within the pixels at which a lens sees something.
double worst(const cv::Mat& a, const cv::Mat& b, const cv::Mat& where = {}) {
  return cv::norm(a, b, cv::NORM_INF, where);
}

/// The light of a picture, many times as bright.
cv::Mat lightTimes(double factor, const cv::Mat& pixels) {
  cv::Mat light(pixels.size(), CV_32FC4);
  for (int v = 0; v < pixels.rows; ++v) {
    for (int u = 0; u < pixels.cols; ++u) {
      for (int c = 0; c < 3; ++c) {
        light.at<cv::Vec4f>(v, u)[c] = static_cast<float>(
            factor * double{render::linearFromSrgb()[pixels.at<cv::Vec4b>(v, u)[c]]});
      }
      light.at<cv::Vec4f>(v, u)[3] = 1.0F;
    }
  }
  return light;
}

TEST(BackgroundOfLight, IsNotCutAtWhite) {
  const cv::Mat pixels = noise({200, 100});
  for (const Projection projection : {Projection::kBackdrop, Projection::kPanorama}) {
    world::Look bright = lookWith(test::dark(), lightTimes(50.0, pixels), projection);
    bright.background_picture->brightness = 1.0 / 50.0;
    const world::Look encoded = lookWith(test::dark(), pixels, projection);
    EXPECT_LE(worst(seenWith(bright), seenWith(encoded)), 1.0);
  }
}

// --- Backdrops ---

TEST(Backdrop, OfTheImagesSizeIsSeenAsItIs) {
  const cv::Mat pixels = noise({65, 49});
  for (const Sampling sampling : {Sampling::kSmooth, Sampling::kCentre}) {
    const cv::Mat seen = seenWith(lookWith(test::dark(), pixels), {kSmallCamera}, sampling);
    EXPECT_EQ(worst(seen, withoutAlpha(pixels)), 0.0);
  }
}

TEST(Backdrop, StaysWhereTheCameraTurns) {
  const cv::Mat pixels = noise({65, 49});
  const Pose turned =
      makePose({1, 2, 3}, Eigen::Quaterniond(Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3) / 14)));
  EXPECT_EQ(
      worst(seenWith(lookWith(test::dark(), pixels), {kSmallCamera, turned}), withoutAlpha(pixels)),
      0.0);
}

TEST(Backdrop, IsCutOnBothSidesToTheImagesProportions) {
  const cv::Mat wide = noise({3 * 65, 49});
  EXPECT_EQ(
      worst(seenWith(lookWith(test::dark(), wide)), withoutAlpha(wide(cv::Rect(65, 0, 65, 49)))),
      0.0);
  const cv::Mat high = noise({65, 3 * 49});
  EXPECT_EQ(
      worst(seenWith(lookWith(test::dark(), high)), withoutAlpha(high(cv::Rect(0, 49, 65, 49)))),
      0.0);
}

TEST(Backdrop, ThatIsLargerIsTheMeanOfItsLight) {
  cv::Mat checkers = plain({130, 98}, {0, 0, 0, 255});
  for (int v = 0; v < 98; ++v) {
    for (int u = v % 2; u < 130; u += 2) checkers.at<cv::Vec4b>(v, u) = {255, 255, 255, 255};
  }
  const double half = render::srgbFromLinear(0.5F);
  EXPECT_LE(worst(seenWith(lookWith(test::dark(), checkers)),
                  cv::Mat(49, 65, CV_8UC3, cv::Scalar::all(half))),
            1.0);
}

TEST(Backdrop, ThatIsSmallerFillsTheImage) {
  cv::Mat halves = plain({2, 2}, {200, 100, 50, 255});
  halves.col(1).setTo(cv::Scalar(20, 40, 80, 255));
  const cv::Mat seen = seenWith(lookWith(test::dark(), halves));
  EXPECT_EQ(seen.at<cv::Vec3b>(0, 0), cv::Vec3b(200, 100, 50));
  EXPECT_EQ(seen.at<cv::Vec3b>(48, 64), cv::Vec3b(20, 40, 80));
}

TEST(Backdrop, GetsBrighterWithTheExposureAndItsOwnBrightness) {
  world::Look look = lookWith(test::dark(), plain({65, 49}, {30, 90, 200, 255}));
  look.background_picture->brightness = 1.5;
  const cv::Vec3b seen =
      seenWith(look, {kSmallCamera}, Sampling::kSmooth, 2.0F).at<cv::Vec3b>(20, 20);
  const auto& linear = render::linearFromSrgb();
  EXPECT_NEAR(seen[0], render::srgbFromLinear(3.0F * linear[30]), 1);
  EXPECT_NEAR(seen[1], render::srgbFromLinear(3.0F * linear[90]), 1);
  EXPECT_EQ(seen[2], 255) << "and is clipped";
}

TEST(Backdrop, TakesTheMiddleOfAPicture) {
  EXPECT_EQ(partFilling({640, 480}, {160, 120}), cv::Rect(0, 0, 640, 480));
  EXPECT_EQ(partFilling({1000, 480}, {160, 120}), cv::Rect(180, 0, 640, 480));
  EXPECT_EQ(partFilling({640, 1000}, {160, 120}), cv::Rect(0, 260, 640, 480));
  EXPECT_EQ(partFilling({1, 1}, {160, 120}), cv::Rect(0, 0, 1, 1));
  EXPECT_EQ(partFilling({10000, 1}, {160, 120}), cv::Rect(4999, 0, 1, 1));
}

// --- Panoramas ---

/// The colour of a direction of the world: waves along each axis, so fine that the pixel next to
/// the right one is some grey levels off.
cv::Vec3d colourOf(const Eigen::Vector3d& direction) {
  const Eigen::Array3d waves = 128.0 + 100.0 * (6.0 * direction.array()).sin();
  return {waves.x(), waves.y(), waves.z()};
}

/// A panorama of these colours.
cv::Mat panoramaOfDirections(int width) {
  cv::Mat pixels(width / 2, width, CV_8UC4);
  for (int v = 0; v < pixels.rows; ++v) {
    const double elevation = kPi * (0.5 - (v + 0.5) / pixels.rows);
    for (int u = 0; u < pixels.cols; ++u) {
      const double azimuth = 2.0 * kPi * (0.5 - (u + 0.5) / pixels.cols);
      const cv::Vec3d colour =
          colourOf({std::cos(elevation) * std::cos(azimuth),
                    std::cos(elevation) * std::sin(azimuth), std::sin(elevation)});
      for (int i = 0; i < 3; ++i) {
        pixels.at<cv::Vec4b>(v, u)[i] = cv::saturate_cast<std::uint8_t>(colour[i]);
      }
      pixels.at<cv::Vec4b>(v, u)[3] = 255;
    }
  }
  return pixels;
}

/// The picture that a camera should see; `where` gets the pixels at which its lens sees something.
cv::Mat expectedOfDirections(const View& view, double yaw, cv::Mat& where) {
  cv::Mat expected(view.camera.height(), view.camera.width(), CV_8UC3, cv::Scalar::all(0));
  where = cv::Mat::zeros(expected.size(), CV_8UC1);
  const Eigen::AngleAxisd unturned(-yaw, Eigen::Vector3d::UnitZ());
  for (int v = 0; v < expected.rows; ++v) {
    for (int u = 0; u < expected.cols; ++u) {
      const auto ray = view.camera.ray({u, v});
      if (!ray) continue;
      const cv::Vec3d colour = colourOf(unturned * (view.X_WC.linear() * *ray));
      for (int i = 0; i < 3; ++i) {
        expected.at<cv::Vec3b>(v, u)[i] = cv::saturate_cast<std::uint8_t>(colour[i]);
      }
      where.at<std::uint8_t>(v, u) = 255;
    }
  }
  return expected;
}

void expectDirections(const View& view, double yaw, int width = 2048, double most_off = 3.0) {
  world::Look look = lookWith(test::dark(), panoramaOfDirections(width), Projection::kPanorama);
  look.background_picture->yaw = yaw;
  cv::Mat where;
  const cv::Mat expected = expectedOfDirections(view, yaw, where);
  const cv::Mat seen = seenWith(look, view);
  test::keep(seen, "panorama");
  EXPECT_LE(worst(seen, expected, where), most_off);
  cv::Mat beside = seen.clone();
  beside.setTo(cv::Scalar::all(0), where);
  EXPECT_EQ(cv::norm(beside, cv::NORM_INF), 0.0) << "where the lens sees nothing";
}

Pose looking(double roll, double pitch, double yaw) {
  return makePose({3, -2, 1}, Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                                  Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                                  Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()));
}

TEST(Panorama, ShowsEachDirectionOfTheWorld) {
  // Along the axes; the seam at -x and both poles are among them.
  for (const Pose& X_WC : {looking(0, 0, 0), looking(kPi, 0, 0.1), looking(-kPi / 2, 0, -kPi / 2),
                           looking(-kPi / 2, 0, kPi / 2), looking(-2.0, 0.3, 0.7)}) {
    expectDirections({kSmallCamera, X_WC}, 0.0, 2048, 6.0);  // half a pixel is 5 grey levels
  }
}

TEST(Panorama, IsTurnedByItsYaw) {
  for (const double yaw : {1.0, -2.5, 6.2}) {
    expectDirections({kSmallCamera, looking(-kPi / 2, 0, 0.4)}, yaw);
  }
}

TEST(Panorama, IsTheSameFineOrCoarse) {
  const View view{kSmallCamera, looking(-2.0, 0.3, 0.7)};
  for (const int width : {1024, 3000}) expectDirections(view, 0.3, width);
}

class ThroughLens : public testing::TestWithParam<test::LensCase> {};

TEST_P(ThroughLens, APanoramaShowsEachDirectionOfTheWorld) {
  expectDirections({GetParam().camera, looking(-2.0, 0.3, 0.7)}, 0.5);
}

/// A picture with eight waves across and eight waves down.
cv::Mat wavesOf(const cv::Size& size) {
  const auto wave = [](int place, int length) {
    return cv::saturate_cast<std::uint8_t>(128 + 100 * std::sin(16 * kPi * (place + 0.5) / length));
  };
  cv::Mat pixels(size, CV_8UC4);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      pixels.at<cv::Vec4b>(v, u) = {wave(u, size.width), wave(v, size.height), 100, 255};
    }
  }
  return pixels;
}

/// Straight lines of the picture stay straight even if the lens bends those of the world.
TEST_P(ThroughLens, ABackdropFillsTheImageAsItIs) {
  const CameraModel& camera = GetParam().camera;
  const View view{camera, looking(-2.0, 0.3, 0.7)};
  const cv::Mat expected = withoutAlpha(wavesOf({camera.width(), camera.height()}));
  cv::Mat where;
  (void)expectedOfDirections(view, 0.0, where);
  Renderer renderer(test::dark(), {}, {});
  for (const int scale : {1, 3}) {
    renderer.setLook(
        lookWith(test::dark(), wavesOf({scale * camera.width(), scale * camera.height()})));
    const cv::Mat seen = renderer.colour(view, {}, {});
    test::keep(seen, std::string("backdrop_") + GetParam().name);
    EXPECT_LE(worst(seen, expected, where), 3.0) << scale;
  }
}

INSTANTIATE_TEST_SUITE_P(, ThroughLens,
                         testing::Values(test::kPlumbBob, test::kRational, test::kFisheye190,
                                         test::kTiltedPrism, test::kOmnidirectional,
                                         test::kDoubleSphere),
                         [](const auto& lens) { return std::string(lens.param.name); });

// --- With things before it ---

/// A ball, a box and a pane of glass that move before a camera that looks along +x.
class BackgroundOfThings : public testing::Test {
 protected:
  BackgroundOfThings() {
    description.background = {0.2F, 0.4F, 0.6F};
    description.lights.emplace_back();
    description.lights[0].direction_L = Eigen::Vector3d(0.5, 0.2, -1).normalized();
    description.lights[0].casts_shadow = true;
    world::Material glass = test::coloured(0.9F, 0.5F, 0.3F);
    glass.diffuse.w() = 0.5F;
    stage.addMesh(world::sphereMesh(0.5), Pose::Identity(), 0, test::coloured(0.9F, 0.2F, 0.2F));
    stage.addBox({0.2, 2, 0.4}, at(1, 0, -0.5), -1, test::coloured(0.3F, 0.6F, 0.3F));
    stage.addBox({0.02, 1, 1}, at(-0.8, -0.4, 0.2), -1, glass);
    options.shadow_map_size = 256;
  }

  static Pose at(double x, double y, double z) {
    return makePose({x, y, z}, Eigen::Quaterniond::Identity());
  }

  [[nodiscard]] std::unique_ptr<Renderer> makeRenderer() const {
    return std::make_unique<Renderer>(description, stage.links(), options);
  }

  [[nodiscard]] cv::Mat draw(Renderer& renderer, const View& from) const {
    return renderer.colour(from, stage.poses(), {stage.all(), stage.all()});
  }

  [[nodiscard]] cv::Mat drawWith(const world::Look& look, const View& from) const {
    const auto renderer = makeRenderer();
    renderer->setLook(look);
    return draw(*renderer, from);
  }

  world::Description description = test::dark();
  Stage stage;
  RenderOptions options;
  View view{kSmallCamera,
            makePose({-3, 0, 0.3}, Eigen::AngleAxisd(-kPi / 2, Eigen::Vector3d::UnitZ()) *
                                       Eigen::AngleAxisd(-kPi / 2, Eigen::Vector3d::UnitX()))};
  const CameraModel bent{65,   49,    {50.0, 50.0, 32.0, 24.0},
                         0.05, 100.0, {DistortionModel::kPlumbBob, {-0.2, 0.05, 0.0, 0.0, 0.0}}};
};

/// A plain picture equals a background colour at edges, behind glass and through lenses.
TEST_F(BackgroundOfThings, OfOneColourIsThatColour) {
  for (const CameraModel& camera : {kSmallCamera, bent}) {
    const View from{camera, view.X_WC};
    world::Look coloured(description);
    coloured.background = Eigen::Vector3f(51, 153, 204) / 255.0F;
    const cv::Mat expected = drawWith(coloured, from);
    for (const Projection projection : {Projection::kBackdrop, Projection::kPanorama}) {
      const cv::Mat found =
          drawWith(lookWith(description, plain({200, 100}, {204, 153, 51, 255}), projection), from);
      EXPECT_LE(worst(found, expected), 1.0);
    }
  }
}

TEST_F(BackgroundOfThings, TakesTheSkysPlace) {
  const world::Look look = lookWith(description, noise({65, 49}));
  const cv::Mat expected = drawWith(look, view);
  description.sky.emplace();
  EXPECT_EQ(worst(drawWith(look, view), expected), 0.0);
  EXPECT_GT(worst(drawWith(world::Look(description), view), expected), 20.0) << "the sky is back";
}

TEST_F(BackgroundOfThings, IsNothingToLabels) {
  const auto renderer = makeRenderer();
  const LabelImages before = renderer->labels(view, stage.poses(), {stage.all()});
  renderer->setLook(lookWith(description, noise({65, 49})));
  (void)draw(*renderer, view);
  const LabelImages after = renderer->labels(view, stage.poses(), {stage.all()});
  EXPECT_EQ(worst(before.ids, after.ids), 0.0);
  EXPECT_EQ(worst(before.depth, after.depth), 0.0);
  EXPECT_EQ(after.depth.at<float>(0, 0), 0.0F);
}

/// Compares pictures of several times in each look by one renderer with those by a new one each.
TEST_F(BackgroundOfThings, IsNotKeptForTheNext) {
  const std::vector<world::Look> looks = {
      lookWith(description, noise({65, 49}, 1)), lookWith(description, noise({65, 49}, 2)),
      lookWith(description, noise({200, 100}, 3), Projection::kPanorama), world::Look(description)};
  for (const CameraModel& camera : {kSmallCamera, bent}) {
    const View from{camera, view.X_WC};
    std::vector<cv::Mat> found;
    const auto forEachPicture = [&](const std::function<void(const world::Look&)>& take) {
      for (const std::size_t look : {0U, 1U, 2U, 3U, 0U}) {
        for (int time = 0; time < 3; ++time) {
          stage.poses()[0] = at(0, 0.2 * time, 0.1 * time);
          take(looks[look]);
        }
      }
    };
    {
      const auto renderer = makeRenderer();
      const world::Look* worn = nullptr;
      forEachPicture([&](const world::Look& look) {
        if (worn != &look) renderer->setLook(look);
        worn = &look;
        found.push_back(draw(*renderer, from));
      });
    }
    std::size_t i = 0;
    options.reuse = false;
    forEachPicture([&](const world::Look& look) {
      EXPECT_EQ(worst(found[i], drawWith(look, from)), 0.0) << i;
      ++i;
    });
    options.reuse = true;
  }
}

/// Regions are drawn for rolling shutters and background subtraction.
TEST_F(BackgroundOfThings, IsTheSameInRegions) {
  const std::vector<cv::Rect> regions = {{0, 10, 65, 7}, {30, 20, 20, 25}};
  for (const Projection projection : {Projection::kBackdrop, Projection::kPanorama}) {
    const auto renderer = makeRenderer();
    renderer->setLook(lookWith(description, noise({200, 100}), projection));
    for (const CameraModel& camera : {kSmallCamera, bent}) {
      const View from{camera, view.X_WC};
      const cv::Mat whole = draw(*renderer, from);
      const ColourPass pass{stage.all(), stage.all(), Sampling::kSmooth, regions};
      const cv::Mat some = renderer->colour(from, stage.poses(), pass);
      for (const cv::Rect& region : regions) EXPECT_EQ(worst(some(region), whole(region)), 0.0);
    }
  }
}

/// Two lenses see the same circle of the world in images of different widths: what is drawn for
/// them differs only in the backdrop.
TEST_F(BackgroundOfThings, IsNotTakenForThatOfAnotherLens) {
  const Distortion narrow{DistortionModel::kNone, {}, 0.3};
  const View first{CameraModel(65, 49, {60.0, 60.0, 32.0, 24.0}, 0.05, 100.0, narrow), view.X_WC};
  const View second{CameraModel(85, 49, {60.0, 60.0, 32.0, 24.0}, 0.05, 100.0, narrow), view.X_WC};
  const world::Look look = lookWith(description, noise({85, 49}));
  const cv::Mat expected = drawWith(look, second);
  const auto renderer = makeRenderer();
  renderer->setLook(look);
  for (int i = 0; i < 3; ++i) (void)draw(*renderer, first);
  EXPECT_EQ(worst(draw(*renderer, second), expected), 0.0);
}

TEST_F(BackgroundOfThings, LetsGoOfAPictureThatIsSeenNoMore) {
  const auto renderer = makeRenderer();
  std::weak_ptr<const world::Texture> seen;
  {
    const world::Look look = lookWith(description, noise({65, 49}));
    seen = look.background_picture->picture;
    renderer->setLook(look);
  }
  (void)draw(*renderer, view);
  EXPECT_FALSE(seen.expired());
  renderer->setLook(world::Look(description));
  EXPECT_TRUE(seen.expired());
}

}  // namespace background_test
}  // namespace synthetic_dataset::render
