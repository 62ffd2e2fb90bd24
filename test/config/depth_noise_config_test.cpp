#include "config/readers.h"

#include <gmock/gmock.h>

#include "base/yaml_value.h"

namespace synthetic_dataset::config {
namespace depth_noise_config_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

struct Reading {
  explicit Reading(const std::string& text)
      : camera(base::parseYaml(text, "test")), noise(readDepthNoise(camera)) {}
  Parameters camera;
  render::DepthNoise noise;
};

TEST(ReadDepthNoise, IsNoneUnlessSet) {
  EXPECT_EQ(Reading("{near: 0.1}").noise.model, render::DepthModel::kExact);
  const Reading none("{depth_noise: {model: none}}");
  EXPECT_EQ(none.noise.model, render::DepthModel::kExact);
  EXPECT_THAT(none.camera.errors(), IsEmpty());
}

TEST(ReadDepthNoise, KnowsAKinectAndAStereoCamera) {
  const Reading kinect("{depth_noise: {model: structured_light, max_depth: 4.0}}");
  EXPECT_THAT(kinect.camera.errors(), IsEmpty());
  EXPECT_EQ(kinect.noise.model, render::DepthModel::kStructuredLight);
  EXPECT_EQ(kinect.noise.baseline, 0.075);
  EXPECT_EQ(kinect.noise.max_depth, 4.0);
  const Reading stereo("{depth_noise: {model: stereo, baseline: 0.12}}");
  EXPECT_THAT(stereo.camera.errors(), IsEmpty());
  EXPECT_EQ(stereo.noise.model, render::DepthModel::kStereo);
  EXPECT_EQ(stereo.noise.baseline, 0.12);
  EXPECT_EQ(stereo.noise.min_depth, 0.0);
}

TEST(ReadDepthNoise, NamesWhatIsWrong) {
  EXPECT_THAT(Reading("{depth_noise: {model: lidar}}").camera.errors(),
              ElementsAre("depth_noise/model: found 'lidar'; it should be none, structured_light "
                          "or stereo"));
  EXPECT_THAT(Reading("{depth_noise: {model: stereo, baseline: 0}}").camera.errors(),
              ElementsAre(testing::HasSubstr("depth_noise/baseline: found 0")));
  EXPECT_THAT(Reading("{depth_noise: {model: structured_light, max_depth: 0.4}}").camera.errors(),
              ElementsAre(testing::HasSubstr("depth_noise/max_depth: found 0.4")));
  EXPECT_THAT(
      Reading("{depth_noise: {model: structured_light, disparity_noise: 0.1}}").camera.errors(),
      ElementsAre("depth_noise/disparity_noise: has a meaning with model: stereo alone"));
  EXPECT_THAT(Reading("{depth_noise: {baseline: 0.1}}").camera.errors(),
              ElementsAre("depth_noise/model: required, but missing"));
}

TEST(ReadDepthNoise, IsSwitchedOffByItsModelAlone) {
  const Reading none("{depth_noise: {model: none, baseline: 0.1, max_angle: 1.0}}");
  EXPECT_THAT(none.camera.errors(), testing::IsEmpty());
  EXPECT_THAT(none.camera.unknownNames(), testing::IsEmpty());
}

}  // namespace depth_noise_config_test
}  // namespace synthetic_dataset::config
