#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "plugins/model_shapes.h"
#include "plugins/plugin_harness.h"

namespace synthetic_dataset {
namespace dope_writer_test {

using nlohmann::json;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;
using testing::Pointwise;

const Cuboid kRover{{-1.0, -0.5, 0.0}, {1.0, 0.5, 0.6}};

class Dope : public PluginTest {
 protected:
  Dope() : PluginTest("synthetic_dataset/Dope") {
    ObjectInfo info;
    info.name = "rover";
    info.class_name = "vehicle";
    info.class_id = 3;
    dataset_.objects = {info};
    dataset_.setModels([](std::size_t) { return cuboidModel(kRover); });
  }

  /// The rover ten metres ahead, its x axis to the right, its z axis up.
  [[nodiscard]] static SceneObject rover() {
    SceneObject object = seen("rover", {100, 80, 50, 40});
    object.class_name = "vehicle";
    object.cuboid_O = kRover;
    object.X_CO->linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    object.X_CO->translation() = Eigen::Vector3d(0.0, 0.0, 10.0);
    return object;
  }

  [[nodiscard]] json labelsOf(const Scene& scene) const {
    return json::parse(filesOf(scene).at(scene.name + ".json"));
  }

  [[nodiscard]] json entryOf(const SceneObject& object) const {
    return labelsOf(scene(0, {object})).at("objects").at(0);
  }

  [[nodiscard]] json jsonOf(const std::string& file) const {
    std::ifstream stream(folder() + file);
    return json::parse(stream);
  }
};

std::vector<double> numbers(const json& list) { return list.get<std::vector<double>>(); }

TEST_F(Dope, PutsLabelsBesideTheImage) {
  load({});
  EXPECT_THAT(filesOf(scene(2, {})), ElementsAre(Pair("00000002.json", HasSubstr("camera_data")),
                                                 Pair("00000002.png", "<image>")));
}

TEST_F(Dope, WarnsOfImagesThatItsLoaderCannotCut) {
  EXPECT_THAT(load({}).warnings(), testing::IsEmpty());
  dataset_.cameras = {
      {"front", "f", CameraModel(640, 360, {500.0, 500.0, 320.0, 180.0}, 0.05, 100.0)}};
  EXPECT_THAT(load({}).warnings(), ElementsAre(testing::AllOf(HasSubstr("of 640 x 360 pixels"),
                                                              HasSubstr("400 x 400"))));
}

TEST_F(Dope, ProjectsCornersInDopesOrderAndThenTheCentre) {
  load({});
  const json places = entryOf(rover()).at("projected_cuboid");
  ASSERT_EQ(places.size(), 9U);
  // The object's y = -0.5 is the face towards the camera, 9.5 m away; z = 0.6 is 0.6 m up. So the
  // first corner (+x, -y, +z) is at (320 + 500 / 9.5, 240 - 300 / 9.5).
  EXPECT_THAT(numbers(places.at(0)),
              Pointwise(DoubleNear(1e-9), {320 + 500 / 9.5, 240 - 300 / 9.5}));
  EXPECT_THAT(numbers(places.at(1)),
              Pointwise(DoubleNear(1e-9), {320 - 500 / 9.5, 240 - 300 / 9.5}));
  EXPECT_THAT(numbers(places.at(2)),
              Pointwise(DoubleNear(1e-9), {320 - 500 / 10.5, 240 - 300 / 10.5}));
  EXPECT_THAT(numbers(places.at(3)),
              Pointwise(DoubleNear(1e-9), {320 + 500 / 10.5, 240 - 300 / 10.5}));
  EXPECT_THAT(numbers(places.at(4)), Pointwise(DoubleNear(1e-9), {320 + 500 / 9.5, 240.0}));
  EXPECT_THAT(numbers(places.at(7)), Pointwise(DoubleNear(1e-9), {320 + 500 / 10.5, 240.0}));
  EXPECT_THAT(numbers(places.at(8)), Pointwise(DoubleNear(1e-9), {320.0, 240.0 - 15.0}));
}

TEST_F(Dope, TellsThePoseInMetres) {
  load({});
  const json entry = entryOf(rover());
  EXPECT_EQ(entry.at("class"), "vehicle");
  EXPECT_EQ(entry.at("name"), "rover");
  EXPECT_EQ(entry.at("visibility"), 1.0);
  EXPECT_EQ(entry.at("location"), json({0.0, 0.0, 10.0}));
  // A quarter turn about x.
  EXPECT_THAT(numbers(entry.at("quaternion_xyzw")),
              Pointwise(DoubleNear(1e-12), {std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)}));
  EXPECT_EQ(entry.at("local_cuboid").at(0), json({1.0, -0.5, 0.6}));
  EXPECT_EQ(entry.at("px_count_visib"), 2000);
  EXPECT_EQ(entry.at("bounding_box_minx_maxx_miny_maxy"), json({100.0, 149.0, 80.0, 119.0}));
}

TEST_F(Dope, ChoosesTheQuaternionWithAPositiveScalar) {
  load({});
  SceneObject object = rover();
  object.X_CO->linear() = Eigen::AngleAxisd(1.5 * M_PI, Eigen::Vector3d::UnitZ()).matrix();
  EXPECT_THAT(numbers(entryOf(object).at("quaternion_xyzw")),
              Pointwise(DoubleNear(1e-12), {0.0, 0.0, -std::sqrt(0.5), std::sqrt(0.5)}));
}

TEST_F(Dope, WritesNddsInCentimetres) {
  load({{"style", "ndds"}});
  const json entry = entryOf(rover());
  EXPECT_EQ(entry.at("location"), json({0.0, 0.0, 1000.0}));
  EXPECT_EQ(entry.at("instance_id"), 1);
  EXPECT_EQ(entry.at("projected_cuboid").size(), 8U);
  EXPECT_THAT(numbers(entry.at("projected_cuboid_centroid")),
              Pointwise(DoubleNear(1e-9), {320.0, 225.0}));
  EXPECT_THAT(numbers(entry.at("cuboid_centroid")),
              Pointwise(DoubleNear(1e-9), {0.0, -30.0, 1000.0}));
  EXPECT_THAT(numbers(entry.at("cuboid").at(0)),
              Pointwise(DoubleNear(1e-9), {100.0, -60.0, 950.0}));
  // For row vectors: the object's z axis, in the camera's frame, is the third row.
  EXPECT_EQ(entry.at("pose_transform").at(2), json({0.0, -1.0, 0.0, 0.0}));
  EXPECT_EQ(entry.at("pose_transform").at(3), json({0.0, 0.0, 1000.0, 1.0}));
  // Rows before columns.
  EXPECT_EQ(entry.at("bounding_box").at("top_left"), json({80.0, 100.0}));
  EXPECT_EQ(entry.at("bounding_box").at("bottom_right"), json({120.0, 150.0}));
}

TEST_F(Dope, DescribesTheCamera) {
  load({});
  Scene placed = scene(0, {});
  placed.X_GC.translation() = Eigen::Vector3d(1.0, 2.0, 3.0);
  const json data = labelsOf(placed).at("camera_data");
  EXPECT_EQ(data.at("width"), 640);
  EXPECT_EQ(data.at("intrinsics").at("cx"), 320.0);
  EXPECT_EQ(data.at("location_worldframe"), json({1.0, 2.0, 3.0}));
  EXPECT_EQ(data.at("quaternion_xyzw_worldframe"), json({0.0, 0.0, 0.0, 1.0}));
  EXPECT_EQ(data.at("camera_look_at").at("at"), json({1.0, 2.0, 4.0}));
  EXPECT_EQ(data.at("camera_view_matrix").at(3), json({-1.0, -2.0, -3.0, 1.0}));
}

TEST_F(Dope, HasAnEmptyListForASceneWithoutLabels) {
  load({});
  SceneObject hidden = rover();
  hidden.pixels.visible = 0;
  SceneObject dropped = rover();
  dropped.dropped = true;
  EXPECT_EQ(labelsOf(scene(0, {})).at("objects"), json::array());
  EXPECT_EQ(labelsOf(scene(0, {hidden, dropped})).at("objects"), json::array());
}

TEST_F(Dope, LeavesOutWhatIsPartlyBehindTheCameraAndWarns) {
  const output::WriterHost& host = load({});
  SceneObject round = rover();
  round.X_CO->translation().setZero();
  EXPECT_EQ(labelsOf(scene(0, {round})).at("objects"), json::array());
  EXPECT_THAT(host.writeScene(scene(0, {round})).warnings,
              ElementsAre(HasSubstr("rover: part of it is behind the camera")));
}

TEST_F(Dope, KeepsCornersOutsideTheImageAndCutsBoxes) {
  load({{"box", "silhouette"}});
  SceneObject object = rover();
  object.silhouette_box = Box{-20.5, -10.5, 29.5, 39.5};
  object.X_CO->translation().x() = -7.0;
  const json entry = entryOf(object);
  EXPECT_LT(entry.at("projected_cuboid").at(1).at(0).get<double>(), 0.0);
  EXPECT_EQ(entry.at("bounding_box_minx_maxx_miny_maxy"), json({0.0, 29.0, 0.0, 39.0}));
}

TEST_F(Dope, WritesSettingsOfCameraAndClasses) {
  load({{"style", "ndds"}});
  runAll({});
  const json object = jsonOf("_object_settings.json").at("exported_objects").at(0);
  EXPECT_EQ(jsonOf("_object_settings.json").at("exported_object_classes"), json({"vehicle"}));
  EXPECT_EQ(object.at("segmentation_class_id"), 3);
  EXPECT_THAT(numbers(object.at("cuboid_dimensions")),
              Pointwise(DoubleNear(1e-9), {200.0, 100.0, 60.0}));
  const json settings = jsonOf("_camera_settings.json").at("camera_settings").at(0);
  EXPECT_EQ(settings.at("intrinsic_settings").at("fx"), 500.0);
  EXPECT_NEAR(settings.at("horizontal_fov").get<double>(), 65.2385, 1e-3);  // 2 atan(320 / 500)
}

TEST_F(Dope, TellsNoSizeOfAnObjectThatHasSeveral) {
  dataset_.objects[0].model_varies = true;
  load({});
  runAll({scene(0, {rover()})});
  const json object = jsonOf("_object_settings.json").at("exported_objects").at(0);
  EXPECT_EQ(object.at("class"), "vehicle");
  EXPECT_EQ(object.count("cuboid_dimensions"), 0U);
  EXPECT_EQ(jsonOf("00000000.json").at("objects").at(0).at("projected_cuboid").size(), 9U);
}

TEST_F(Dope, WritesEachImagesIntrinsicsAndNoneForAllWhereTheyVary) {
  dataset_.cameras[0].intrinsics_vary = true;
  load({});
  const Scene narrow = zoomed(scene(1, {rover()}), 700.0);
  runAll({scene(0, {rover()}), narrow});
  EXPECT_EQ(jsonOf("00000000.json").at("camera_data").at("intrinsics").at("fx"), 500.0);
  EXPECT_EQ(jsonOf("00000001.json").at("camera_data").at("intrinsics").at("fx"), 700.0);
  const json places = jsonOf("00000001.json").at("objects").at(0).at("projected_cuboid");
  EXPECT_THAT(numbers(places.at(0)),
              Pointwise(DoubleNear(1e-9), {320 + 700 / 9.5, 240 - 420 / 9.5}));
  EXPECT_FALSE(std::filesystem::exists(folder() + "_camera_settings.json"));
  EXPECT_TRUE(std::filesystem::exists(folder() + "_object_settings.json"));
}

TEST_F(Dope, HasFoldersForSplitsAndCameras) {
  dataset_.splits = {{"train", 1}, {"val", 1}};
  dataset_.cameras = {{"front", "f", camera()}, {"rear", "r", camera()}};
  load({});
  Scene front = scene(0, {rover()});
  front.split = "train";
  Scene rear = scene(3, {rover()});
  rear.split = "val";
  rear.camera_index = 1;
  rear.instant = 1;
  runAll({front, rear});
  for (const char* file : {"train/front/00000000.json", "val/rear/00000001.png",
                           "train/front/_camera_settings.json", "val/rear/_object_settings.json"}) {
    EXPECT_TRUE(std::filesystem::exists(folder() + file)) << file;
  }
}

TEST_F(Dope, WarnsOfALensThatTheFormatCannotExpress) {
  const output::WriterHost& host = load({});
  Distortion lens;
  lens.model = DistortionModel::kPlumbBob;
  lens.coefficients[0] = -0.2;
  Scene distorted = scene(0, {});
  distorted.camera = CameraModel(640, 480, {500.0, 500.0, 320.0, 240.0}, 0.05, 100.0, lens);
  EXPECT_THAT(host.writeScene(distorted).warnings, ElementsAre(HasSubstr("no lens distortion")));
}

TEST_F(Dope, RefusesOtherStyles) {
  load({{"style", "fat"}});
  EXPECT_THAT(parameters_.errors(), ElementsAre(HasSubstr("w/style: found 'fat'")));
}

TEST_F(Dope, LabelsThreeHundredObjects) {
  load({});
  const json objects = labelsOf(scene(0, std::vector<SceneObject>(300, rover()))).at("objects");
  EXPECT_EQ(objects.size(), 300U);
  EXPECT_EQ(objects.at(299).at("segmentation_id"), 300);
}

}  // namespace dope_writer_test
}  // namespace synthetic_dataset
