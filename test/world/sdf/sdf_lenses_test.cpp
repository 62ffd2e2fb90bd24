#include <cmath>

#include <gmock/gmock.h>

#include "world/sdf/sdf_loader_support.h"
#include "world/world_loader.h"

namespace synthetic_dataset::world {
namespace sdf_lenses_test {

using namespace test;

constexpr const char* kImage = "<image><width>800</width><height>800</height></image>";

std::string sensor(const std::string& type, const std::string& camera) {
  return worldFile(
      modelElement("robot", linkElement("<sensor name='eye' type='" + type + "'><camera>" + camera +
                                        kImage + "</camera></sensor>")));
}

std::string wideAngle(const std::string& field_of_view, const std::string& lens) {
  return sensor("wideanglecamera",
                "<horizontal_fov>" + field_of_view + "</horizontal_fov><lens>" + lens + "</lens>");
}

CameraModel load(const std::string& text) {
  const TemporaryFolder folder;
  return loadText(folder, text).cameras.at(0).camera;
}

std::string camera(const std::string& content) {
  return sensor("camera", "<horizontal_fov>1.2</horizontal_fov>" + content);
}

TEST(SdfDistortion, IsOpenCvsPlumbBob) {
  const CameraModel model =
      load(camera("<distortion><k1>-0.25</k1><k2>0.12</k2><k3>0.01</k3><p1>-0.0003</p1>"
                  "<p2>-0.0005</p2><center>0.5 0.5</center></distortion>"));
  EXPECT_EQ(model.distortion().model, DistortionModel::kPlumbBob);
  Distortion expected;
  expected.coefficients = {-0.25, 0.12, -0.0003, -0.0005, 0.01};
  EXPECT_EQ(model.distortion().coefficients, expected.coefficients);
}

TEST(SdfDistortion, OfZerosIsNone) {
  EXPECT_EQ(load(camera("<distortion><k1>0</k1></distortion>")).distortion().model,
            DistortionModel::kNone);
}

TEST(SdfDistortion, AboutAnotherPointLeavesTheCameraOutWithANote) {
  const TemporaryFolder folder;
  const Description world =
      loadText(folder, camera("<distortion><k1>-0.1</k1><center>0.4 0.5</center></distortion>"));
  EXPECT_THAT(world.cameras, IsEmpty());
  EXPECT_THAT(world.notes, ElementsAre(AllOf(HasSubstr("sensor 'eye': distortion/center"),
                                             HasSubstr("left out"))));
}

TEST(SdfNoise, IsReadAsAShareOfFullScale) {
  const TemporaryFolder folder;
  const CameraSensor found =
      loadText(folder, camera("<noise><type>gaussian</type><mean>0.01</mean><stddev>0.007</stddev>"
                              "</noise>"))
          .cameras.at(0);
  EXPECT_DOUBLE_EQ(found.noise.mean, 0.01);
  EXPECT_DOUBLE_EQ(found.noise.stddev, 0.007);
}

TEST(SdfNoise, OfMoreThanFullScaleCostsTheCamera) {
  const TemporaryFolder folder;
  EXPECT_THAT(notesOf(folder, camera("<noise><type>gaussian</type><stddev>7</stddev></noise>")),
              ElementsAre(HasSubstr("sensor 'eye': noise: found")));
}

TEST(SdfLens, EquidistantFillsTheImagesWidth) {
  const CameraModel model =
      load(wideAngle("3.4",
                     "<type>equidistant</type><scale_to_hfov>true</scale_to_hfov>"
                     "<cutoff_angle>1.7</cutoff_angle>"));
  EXPECT_EQ(model.distortion().model, DistortionModel::kEquidistant);
  EXPECT_NEAR(model.intrinsics().fx, 400.0 / 1.7, 1e-9);
  EXPECT_NEAR(model.largestAngle(), 1.7, 1e-9);
  EXPECT_NEAR(model.ray({799.5, 399.5})->z(), std::cos(1.7), 1e-6);
}

/// The radius on the image [px] at an angle from the axis.
double radiusOf(const CameraModel& model, double angle) {
  const auto pixel = model.project({std::sin(angle), 0.0, std::cos(angle)});
  return pixel ? pixel->x() - model.intrinsics().cx : std::nan("");
}

TEST(SdfLens, MapsAsItsFormulaSays) {
  const auto expectRadius = [](const char* type, auto formula) {
    const CameraModel model = load(
        wideAngle("2.6", std::string("<type>") + type + "</type><cutoff_angle>1.3</cutoff_angle>"));
    for (double angle = 0.05; angle < 1.3; angle += 0.05) {
      EXPECT_NEAR(radiusOf(model, angle), 400.0 * formula(angle) / formula(1.3), 0.06)
          << type << " at " << angle;
    }
  };
  expectRadius("stereographic", [](double t) { return std::tan(t / 2); });
  expectRadius("equisolid_angle", [](double t) { return std::sin(t / 2); });
  expectRadius("orthographic", [](double t) { return std::sin(t); });
  expectRadius("gnomonical", [](double t) { return std::tan(t); });
}

TEST(SdfLens, TakesACustomFunctionUnscaled) {
  const CameraModel model =
      load(wideAngle("2.0",
                     "<type>custom</type><scale_to_hfov>false</scale_to_hfov><custom_function>"
                     "<c1>1.05</c1><c2>4</c2><f>2.0</f><fun>tan</fun></custom_function>"
                     "<cutoff_angle>1.4</cutoff_angle>"));
  EXPECT_NEAR(radiusOf(model, 0.8), 400.0 * 1.05 * 2.0 * std::tan(0.2), 0.06);
}

TEST(SdfLens, OfAnUnknownTypeCostsTheCamera) {
  const TemporaryFolder folder;
  EXPECT_THAT(
      notesOf(folder, wideAngle("2.0", "<type>panoramic</type>")),
      ElementsAre(AllOf(HasSubstr("lens/type: found 'panoramic'"), HasSubstr("equisolid_angle"))));
}

TEST(SdfLens, WithAnOffsetLeavesTheCameraOutWithANote) {
  const TemporaryFolder folder;
  const Description world =
      loadText(folder, wideAngle("2.0",
                                 "<type>custom</type><custom_function><c3>0.3</c3><fun>tan</fun>"
                                 "</custom_function>"));
  EXPECT_THAT(world.cameras, IsEmpty());
  EXPECT_THAT(world.notes, ElementsAre(HasSubstr("lens/custom_function/c3")));
}

}  // namespace sdf_lenses_test
}  // namespace synthetic_dataset::world
