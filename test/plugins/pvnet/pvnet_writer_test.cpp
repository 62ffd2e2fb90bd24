#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "plugins/model_shapes.h"
#include "plugins/plugin_harness.h"
#include "support/error_messages.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
namespace pvnet_writer_test {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

const Cuboid kRover{{-1.0, -0.5, 0.0}, {1.0, 0.5, 0.6}};

class PvNet : public PluginTest {
 protected:
  PvNet() : PluginTest("synthetic_dataset/PvNet") {
    addObject("rover", cuboidModel(kRover));
    dataset_.setModels([this](std::size_t object) { return models_.at(object); });
  }

  void addObject(const std::string& name, const ObjectModel& model) {
    ObjectInfo info;
    info.name = name;
    info.class_name = "vehicle";
    dataset_.objects.push_back(info);
    models_.push_back(model);
  }

  /// The rover, turned, six metres away.
  [[nodiscard]] static SceneObject rover() {
    SceneObject object = seen("rover", {100, 80, 50, 40});
    object.cuboid_O = kRover;
    object.X_CO->linear() =
        Eigen::AngleAxisd(1.1, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).matrix();
    object.X_CO->translation() = Eigen::Vector3d(-0.4, 0.2, 6.0);
    return object;
  }

  [[nodiscard]] static SceneObject hidden() {
    SceneObject object = rover();
    object.pixels.visible = 0;
    return object;
  }

  [[nodiscard]] std::string contentOf(const std::string& file) const {
    std::ifstream stream(folder() + file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  [[nodiscard]] json jsonOf(const std::string& file) const { return json::parse(contentOf(file)); }

  [[nodiscard]] std::vector<double> numbersOf(const std::string& file) const {
    std::istringstream stream(contentOf(file));
    return {std::istream_iterator<double>(stream), {}};
  }

  [[nodiscard]] std::vector<std::string> namesIn(const std::string& path) const {
    std::vector<std::string> names;
    for (const auto& each : std::filesystem::directory_iterator(folder() + path)) {
      names.push_back(each.path().filename().string());
    }
    return names;
  }

  std::vector<ObjectModel> models_;
};

TEST_F(PvNet, KeepsASamplesFilesUnderTheScenesName) {
  load({});
  const auto files = filesOf(scene(12, {rover()}));
  EXPECT_EQ(files.size(), 3U);
  EXPECT_EQ(files.at("rover/scenes/rgb/00000012.jpg"), "<image>");
  EXPECT_EQ(files.at("rover/scenes/mask/00000012.png"), "<visible rover>");
  EXPECT_EQ(files.count("rover/scenes/pose/00000012.npy"), 1U);
}

TEST_F(PvNet, NumbersSamplesWithoutGaps) {
  load({});
  runAll({scene(0, {hidden()}), scene(1, {rover()}), scene(2, {hidden()}), scene(3, {rover()})});
  EXPECT_THAT(namesIn("rover/rgb"), UnorderedElementsAre("0.jpg", "1.jpg"));
  EXPECT_THAT(namesIn("rover/mask"), UnorderedElementsAre("0.png", "1.png"));
  EXPECT_THAT(namesIn("rover/pose"), UnorderedElementsAre("pose0.npy", "pose1.npy"));
  EXPECT_TRUE(std::filesystem::equivalent(folder() + "rover/rgb/1.jpg",
                                          folder() + "rover/scenes/rgb/00000003.jpg"));
}

TEST_F(PvNet, WritesThePoseAsANumPyArray) {
  load({});
  SceneObject object = rover();
  const std::string file = filesOf(scene(0, {object})).at("rover/scenes/pose/00000000.npy");
  ASSERT_EQ(file.size(), 128U + 12 * 8);
  EXPECT_EQ(file.substr(0, 10), std::string("\x93NUMPY\x01\x00\x76\x00", 10));  // 118 follow
  EXPECT_THAT(file.substr(10, 118),
              HasSubstr("{'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }   "));
  EXPECT_EQ(file[127], '\n');
  double numbers[12];  // on a little-endian machine
  std::memcpy(numbers, file.data() + 128, sizeof numbers);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      EXPECT_EQ(numbers[4 * row + column], object.X_CO->matrix()(row, column));
    }
  }
}

TEST_F(PvNet, WritesTheModelInMetres) {
  load({});
  runAll({});
  EXPECT_THAT(contentOf("rover/model.ply"), HasSubstr("\n-1 -0.5 0 "));
  EXPECT_THAT(numbersOf("rover/diameter.txt"), ElementsAre(kRover.size().norm()));
  EXPECT_THAT(numbersOf("rover/camera.txt"), ElementsAre(500, 0, 320, 0, 500, 240, 0, 0, 1));
}

TEST_F(PvNet, ChoosesFarthestPointsBeginningFarthestFromTheCentre) {
  // Nine points on a line. The box's centre, 0.5, counts as a first choice that is not listed: the
  // ends are 8.5 from it.
  ObjectModel line;
  for (const double x : {0.0, 1.0, -1.0, 2.0, -8.0, 5.0, -4.0, 9.0, -6.0}) {
    line.vertices.push_back({{x, 0.0, 0.0}, Eigen::Vector3d::UnitZ(), {}});
  }
  models_[0] = line;
  load({});
  runAll({});
  std::vector<double> chosen;
  const auto numbers = numbersOf("rover/fps.txt");
  ASSERT_EQ(numbers.size(), 24U);
  for (std::size_t i = 0; i < 24; i += 3) chosen.push_back(numbers[i]);
  // Then, with the distance to the nearest of those: 5 and -4 (4 from the ends), -6 (2), -1 and 2
  // (1.5 from the centre), 0 and 1 (0.5). Of two that are equally far, the earlier comes first.
  EXPECT_THAT(chosen, ElementsAre(-8.0, 9.0, 5.0, -4.0, -6.0, -1.0, 2.0, 0.0));
}

TEST_F(PvNet, TellsWhereItsPointsAreInTheImage) {
  load({});
  const SceneObject object = rover();
  runAll({scene(0, {hidden()}), scene(1, {object})});
  const json train = jsonOf("rover/train.json");
  EXPECT_EQ(train.at("images"), json::parse(R"([{"file_name": "data/custom/rgb/0.jpg",
      "height": 480, "width": 640, "id": 1}])"));
  ASSERT_EQ(train.at("annotations").size(), 1U);
  const json& annotation = train.at("annotations").at(0);
  EXPECT_EQ(annotation.at("mask_path"), "data/custom/mask/0.png");
  EXPECT_EQ(annotation.at("image_id"), 1);
  EXPECT_EQ(annotation.at("id"), 1);

  const json& pose = annotation.at("pose");
  const json& k = annotation.at("K");
  const auto reprojected = [&](const json& p) {  // clean-pvnet's base_utils.project
    double q[3];
    for (std::size_t i = 0; i < 3; ++i) {
      q[i] = pose.at(i).at(3);
      for (std::size_t j = 0; j < 3; ++j)
        q[i] += pose.at(i).at(j).get<double>() * p.at(j).get<double>();
    }
    return Eigen::Vector2d(k.at(0).at(0).get<double>() * q[0] / q[2] + k.at(0).at(2).get<double>(),
                           k.at(1).at(1).get<double>() * q[1] / q[2] + k.at(1).at(2).get<double>());
  };
  for (const char* kind : {"corner", "fps"}) {
    const json& in_3d = annotation.at(std::string(kind) + "_3d");
    const json& in_2d = annotation.at(std::string(kind) + "_2d");
    ASSERT_EQ(in_3d.size(), 8U);
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_NEAR(reprojected(in_3d.at(i)).x(), in_2d.at(i).at(0).get<double>(), 1e-9);
      EXPECT_NEAR(reprojected(in_3d.at(i)).y(), in_2d.at(i).at(1).get<double>(), 1e-9);
    }
  }
  const auto corner = camera().project(*object.X_CO * kRover.corners()[6]);
  EXPECT_NEAR(annotation.at("corner_2d").at(6).at(0).get<double>(), corner->x(), 1e-9);
  EXPECT_EQ(annotation.at("corner_3d").at(1), json({-1.0, -0.5, 0.6}));
  EXPECT_EQ(annotation.at("center_3d"), json({0.0, 0.0, 0.3}));
}

TEST_F(PvNet, PutsSplitsIntoFilesOfTheirOwn) {
  dataset_.splits = {{"train", 2}, {"val", 1}, {"test", 0}};
  load({{"data_root", "elsewhere"}, {"image_format", "png"}});
  std::vector<Scene> scenes = {scene(0, {rover()}), scene(1, {rover()}), scene(2, {rover()})};
  scenes[0].split = scenes[2].split = "train";
  scenes[1].split = "val";
  runAll(scenes);
  const json train = jsonOf("rover/train.json");
  ASSERT_EQ(train.at("images").size(), 2U);
  EXPECT_EQ(train.at("images").at(1).at("file_name"), "elsewhere/rgb/2.png");
  EXPECT_EQ(train.at("images").at(1).at("id"), 2);
  EXPECT_EQ(train.at("annotations").at(1).at("mask_path"), "elsewhere/mask/2.png");
  EXPECT_EQ(jsonOf("rover/val.json").at("images").at(0).at("file_name"), "elsewhere/rgb/1.png");
  EXPECT_THAT(jsonOf("rover/test.json").at("images"), IsEmpty());
}

TEST_F(PvNet, LeavesOutWhatIsPartlyBehindTheCamera) {
  const output::WriterHost& host = load({});
  for (const Eigen::Vector3d& p_C : {Eigen::Vector3d(0.0, 0.0, 0.5), Eigen::Vector3d(0, 0, 0)}) {
    SceneObject object = rover();
    object.X_CO->translation() = p_C;
    const auto result = host.writeScene(scene(0, {object}));
    EXPECT_THAT(result.files.files, IsEmpty());
    EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("rover: part of it is behind")));
  }
}

TEST_F(PvNet, KeepsSamplesThatReachOutOfTheImage) {
  load({});
  for (const double x : {-4.0, 4.0}) {
    SceneObject object = rover();
    object.X_CO->translation() = Eigen::Vector3d(x, x, 6.0);
    EXPECT_EQ(filesOf(scene(0, {object})).size(), 3U);
  }
}

TEST_F(PvNet, LeavesOutWhatIsHiddenOrDropped) {
  load({});
  SceneObject dropped = rover();
  dropped.dropped = true;
  EXPECT_THAT(filesOf(scene(0, {hidden()})), IsEmpty());
  EXPECT_THAT(filesOf(scene(0, {dropped})), IsEmpty());
}

TEST_F(PvNet, HasNoFolderForAnObjectWithoutSurface) {
  models_[0] = {};
  load({});
  runAll({scene(0, {rover()})});
  EXPECT_FALSE(std::filesystem::exists(folder() + "rover"));
}

TEST_F(PvNet, FinishesADatasetWithoutScenes) {
  load({});
  runAll({});
  EXPECT_THAT(jsonOf("rover/train.json").at("images"), IsEmpty());
  EXPECT_THAT(jsonOf("rover/train.json").at("annotations"), IsEmpty());
  EXPECT_EQ(jsonOf("rover/train.json").at("categories").at(0).at("id"), 1);
}

TEST_F(PvNet, GivesEachObjectAndCameraAFolder) {
  addObject("fork lift", cuboidModel(kRover));
  dataset_.cameras = {{"front", "f", camera()},
                      {"rear", "r", {640, 480, {400.0, 400.0, 320.0, 240.0}, 0.05, 100.0}}};
  load({});
  SceneObject lift = rover();
  lift.name = "fork lift";
  Scene front = scene(0, {rover(), hidden()});
  Scene rear = scene(1, {rover(), lift});
  rear.instant = 0;
  rear.camera_index = 1;
  runAll({front, rear});
  const std::string name = "fork lift";
  EXPECT_THAT(namesIn("rover/front/rgb"), ElementsAre("0.jpg"));
  EXPECT_THAT(namesIn("rover/rear/rgb"), ElementsAre("0.jpg"));
  EXPECT_THAT(namesIn(name + "/rear/rgb"), ElementsAre("0.jpg"));
  EXPECT_THAT(jsonOf(name + "/front/train.json").at("images"), IsEmpty());
  EXPECT_EQ(numbersOf("rover/rear/camera.txt").at(0), 400.0);
}

TEST_F(PvNet, RefusesACameraWhoseIntrinsicsVary) {
  dataset_.cameras = {{"front", "f", camera()}, {"rear", "r", camera(), true}};
  EXPECT_THAT(
      test::messagesOf([&] { load({}); }),
      testing::ElementsAre(AllOf(
          HasSubstr("writer 'w': "), HasSubstr("'rear'"), HasSubstr("one camera.txt"),
          HasSubstr("randomize/sensor/field_of_view"), HasSubstr("calibration in all motions"))));
}

TEST_F(PvNet, RefusesAnObjectWhoseModelVaries) {
  dataset_.objects[0].model_varies = true;
  EXPECT_THAT(test::messagesOf([&] { load({}); }),
              testing::ElementsAre(AllOf(HasSubstr("'" + dataset_.objects[0].name + "'"),
                                         HasSubstr("one model.ply of it"),
                                         HasSubstr("without model, scale and variety"))));
}

TEST_F(PvNet, WarnsOfALensThatTheFormatCannotExpress) {
  const output::WriterHost& host = load({});
  Distortion lens;
  lens.model = DistortionModel::kRationalPolynomial;
  lens.coefficients[5] = 0.01;
  Scene distorted = scene(0, {});
  distorted.camera = CameraModel(640, 480, {500.0, 500.0, 320.0, 240.0}, 0.05, 100.0, lens);
  EXPECT_THAT(host.writeScene(distorted).warnings, ElementsAre(HasSubstr("no lens distortion")));
}

TEST_F(PvNet, TellsThreeHundredObjectsApart) {
  std::vector<SceneObject> objects = {rover()};
  for (int i = 1; i < 300; ++i) {
    addObject("o" + std::to_string(i), cuboidModel(kRover));
    objects.push_back(i % 2 == 0 ? rover() : hidden());
    objects.back().name = "o" + std::to_string(i);
  }
  load({});
  const auto files = filesOf(scene(0, objects));
  EXPECT_EQ(files.size(), 150U * 3);
  EXPECT_EQ(files.count("o298/scenes/rgb/00000000.jpg"), 1U);
  EXPECT_EQ(files.count("o299/scenes/rgb/00000000.jpg"), 0U);
}

}  // namespace pvnet_writer_test
}  // namespace synthetic_dataset
