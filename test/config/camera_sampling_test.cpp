#include "config/readers.h"

#include <gmock/gmock.h>

#include "base/yaml_value.h"

namespace synthetic_dataset::config {
namespace camera_sampling_test {

using base::Distribution;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

struct Reading {
  explicit Reading(const std::string& sample)
      : root(base::parseYaml("camera: {sample: {" + sample + "}}", "test")) {
    sampling = readCameraSampling(root.group("camera")).value();
  }
  Parameters root;
  randomize::CameraSampling sampling;
};

std::pair<double, double> rangeOf(const Distribution& distribution) {
  return {distribution.lowest(), distribution.highest()};
}

std::vector<double> drawn(const Distribution& distribution) {
  base::RandomSource source(1);
  return distribution.draw(source);
}

TEST(ReadCameraSampling, IsNothingWithoutItsGroup) {
  Parameters root(base::parseYaml("camera: {pose: [0, 0, 0, 0, 0, 0, 1]}", "test"));
  EXPECT_FALSE(readCameraSampling(root.group("camera")));
}

TEST(ReadCameraSampling, LooksAtAnyObjectFromAShellByDefault) {
  const Reading reading("");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  const randomize::CameraSampling& sampling = reading.sampling;
  EXPECT_EQ(sampling.look_at, "any");
  EXPECT_FALSE(sampling.look_at_point_G);
  EXPECT_THAT(drawn(sampling.aim_offset), ElementsAre(0, 0, 0));
  EXPECT_THAT(rangeOf(sampling.distance), Pair(1.0, 3.0));
  EXPECT_THAT(rangeOf(sampling.elevation), Pair(0.2, 1.0));
  EXPECT_NEAR(sampling.azimuth.lowest(), -M_PI, 1e-9);
  EXPECT_NEAR(sampling.azimuth.highest(), M_PI, 1e-9);
  EXPECT_FALSE(sampling.position_G);
  EXPECT_THAT(rangeOf(sampling.roll), Pair(0.0, 0.0));
  EXPECT_EQ(sampling.clearance, 0.1);
  EXPECT_EQ(sampling.tries, 1000);
}

TEST(ReadCameraSampling, ReadsLengthsInSizesOfWhatItLooksAt) {
  EXPECT_FALSE(Reading("unit: metres").sampling.is_relative_to_size);
  const Reading reading("unit: sizes, distance: {log_uniform: [2, 20]}");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_TRUE(reading.sampling.is_relative_to_size);
  EXPECT_THAT(Reading("unit: sizes, look_at: [1, 2, 3]").root.errors(),
              ElementsAre(HasSubstr("camera/sample/unit: found sizes beside a point")));
}

TEST(ReadCameraSampling, ReadsAShell) {
  const Reading reading(
      "look_at: alpha, distance: {uniform: [2, 4]}, elevation: 0.5, azimuth: {uniform: [-1, 1]}, "
      "aim_offset: {uniform: [[-0.1, -0.2, 0], [0.1, 0.2, 0.3]]}, roll: {normal: [0, 0.1]}, "
      "clearance: 0.25, tries: 20");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_THAT(reading.root.unknownNames(), IsEmpty());
  const randomize::CameraSampling& sampling = reading.sampling;
  EXPECT_EQ(sampling.look_at, "alpha");
  EXPECT_THAT(rangeOf(sampling.distance), Pair(2.0, 4.0));
  EXPECT_THAT(rangeOf(sampling.elevation), Pair(0.5, 0.5));
  EXPECT_THAT(rangeOf(sampling.azimuth), Pair(-1.0, 1.0));
  EXPECT_EQ(sampling.aim_offset.dimension(), 3U);
  EXPECT_THAT(rangeOf(sampling.aim_offset), Pair(-0.2, 0.3));
  EXPECT_LT(sampling.roll.lowest(), -1.0);
  EXPECT_EQ(sampling.clearance, 0.25);
  EXPECT_EQ(sampling.tries, 20);
}

TEST(ReadCameraSampling, ReadsABox) {
  const Reading reading("position: {uniform: [[-5, -5, 1], [5, 5, 2]]}, look_at: all");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  ASSERT_TRUE(reading.sampling.position_G);
  EXPECT_EQ(reading.sampling.position_G->dimension(), 3U);
  EXPECT_THAT(rangeOf(*reading.sampling.position_G), Pair(-5.0, 5.0));
  EXPECT_EQ(reading.sampling.look_at, "all");
}

TEST(ReadCameraSampling, ReadsAPointToLookAt) {
  const Reading reading("look_at: [1, 2.5, -3]");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_EQ(reading.sampling.look_at_point_G, Eigen::Vector3d(1, 2.5, -3));
}

TEST(ReadCameraSampling, MayHaveNoClearance) {
  const Reading reading("clearance: 0");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_EQ(reading.sampling.clearance, 0.0);
}

struct BadSampling {
  std::string text;
  std::string message;
};

class BadSamplings : public ::testing::TestWithParam<BadSampling> {};

TEST_P(BadSamplings, AreNamedWithWhatWouldBeRight) {
  EXPECT_THAT(Reading(GetParam().text).root.errors(), ElementsAre(HasSubstr(GetParam().message)));
}

INSTANTIATE_TEST_SUITE_P(
    ReadCameraSampling, BadSamplings,
    ::testing::Values(
        BadSampling{"look_at: [1, 2]",
                    "camera/sample/look_at: found 2 numbers; it should be any, all, an object's "
                    "name or a point [x, y, z] of global_frame"},
        BadSampling{"look_at: []", "camera/sample/look_at: found 0 numbers"},
        BadSampling{"look_at: [a, b, c]", "camera/sample/look_at: found [a, b, c]"},
        BadSampling{"look_at: 3", "camera/sample/look_at: found 3"},
        BadSampling{"position: [0, 0, 1], distance: 2",
                    "camera/sample/distance: found together with position; the camera's place "
                    "should come from one of them"},
        BadSampling{"position: [0, 0, 1], elevation: 1",
                    "camera/sample/elevation: found together with position"},
        BadSampling{"position: [0, 0, 1], azimuth: 1",
                    "camera/sample/azimuth: found together with position"},
        BadSampling{"position: [0, 0]", "camera/sample/position: found [0, 0]"},
        BadSampling{"distance: 0", "camera/sample/distance: found 0"},
        BadSampling{"distance: {uniform: [-1, 1]}", "camera/sample/distance: found uniform"},
        BadSampling{"elevation: 1.6", "camera/sample/elevation: found 1.6"},
        BadSampling{"azimuth: 7", "camera/sample/azimuth: found 7"},
        BadSampling{"roll: -7", "camera/sample/roll: found -7"},
        BadSampling{"aim_offset: {uniform: [1]}", "camera/sample/aim_offset: found uniform: [1]"},
        BadSampling{"clearance: -0.1",
                    "camera/sample/clearance: found -0.1; it should be 0.0 to 1000000.0"},
        BadSampling{"tries: 0", "camera/sample/tries: found 0; it should be 1 to 1000000"}));

TEST(ReadCameraSampling, IsOfItsOwnCameraAmongSeveral) {
  Parameters root(base::parseYaml("cameras: {left: {sample: {clearance: -1}}}", "test"));
  (void)readCameraSampling(root.group("cameras").group("left"));
  EXPECT_THAT(root.errors(), ElementsAre(HasSubstr("cameras/left/sample/clearance: found -1.0")));
}

}  // namespace camera_sampling_test
}  // namespace synthetic_dataset::config
