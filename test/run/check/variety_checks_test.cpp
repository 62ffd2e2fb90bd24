#include "run/check/variety_checks.h"

#include <gmock/gmock.h>
#include <opencv2/core/mat.hpp>

#include "run/check/run_check.h"
#include "run/run_fixture.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace variety_checks_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

const CameraModel kCamera(640, 480, {500.0, 500.0, 320.0, 240.0}, 0.05, 100.0);

/// A plain image without labels, 640 px wide, whose left half has stripes of 20 px.
Scene stripedScene() {
  Scene scene(kCamera);
  scene.image = cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(90));
  for (int x = 0; x < 320; x += 40) scene.image.colRange(x, x + 20) = cv::Scalar::all(160);
  return scene;
}

TEST(SurroundingDetail, IsTheShareThatIsNotPlain) {
  // The image shrinks to 64 columns. Half of the 32 striped ones have another tone at their right.
  EXPECT_NEAR(surroundingDetail(stripedScene()).value(), 16.0 / 63.0, 0.02);
}

TEST(SurroundingDetail, IsNotThatOfLabels) {
  Scene scene = stripedScene();
  SceneObject object;
  object.pixels.visible = 1000;
  object.visible_mask = Mask(cv::Mat1b(480, 320, 255), {}, scene.image.size());
  scene.objects.push_back(object);
  EXPECT_EQ(surroundingDetail(scene), 0.0);
  scene.objects.back().visible_mask = Mask(cv::Mat1b(480, 640, 255));
  EXPECT_EQ(surroundingDetail(scene), std::nullopt);
}

TEST(SurroundingDetail, IsNotThatOfASensorsNoise) {
  Scene scene(kCamera);
  scene.image = cv::Mat(480, 640, CV_8UC3);
  cv::RNG random(1);
  random.fill(scene.image, cv::RNG::NORMAL, cv::Scalar::all(120), cv::Scalar::all(8));
  EXPECT_EQ(surroundingDetail(scene), 0.0);
}

TEST(CheckVariety, WarnsOfOneModelOnAPlainGround) {
  const std::vector<Finding> findings = checkVariety({0.03, {{"cone", 1}, {"box", 1}}});
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_THAT(findings[0].message(), HasSubstr("nothing else in view (3 % of what surrounds"));
  EXPECT_THAT(findings[0].cure, HasSubstr("`randomize: {preset: transfer}`"));
  EXPECT_THAT(checkVariety({0.28, {{"cone", 1}}}), IsEmpty());
  EXPECT_THAT(checkVariety({0.03, {{"cone", 12}}}), IsEmpty());
}

class VarietyTest : public test::RunFixture {
 protected:
  [[nodiscard]] SceneVariety variety() const {
    Reporter silent;
    return checkRun(Value(parameters), silent, {test::pluginXml()}).variety.value();
  }
};

TEST_F(VarietyTest, CountsTheLooksOfEachClass) {
  EXPECT_THAT(variety().looks, ElementsAre(Pair("box", 2))) << "two models of the world";
  parameters["randomize"] =
      Value(Value::Map{{"variety", Value("same_object")}, {"variants", Value(3)}});
  (*parameters["bravo"].as<Value::Map>())["class"] = Value("other");
  EXPECT_THAT(variety().looks, ElementsAre(Pair("box", 3), Pair("other", 3)));
}

}  // namespace variety_checks_test
}  // namespace synthetic_dataset::run
