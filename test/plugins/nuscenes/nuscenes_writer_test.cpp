#include <array>
#include <cstring>
#include <filesystem>
#include <map>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "plugins/nuscenes/nuscenes_scenes.h"
#include "plugins/plugin_harness.h"

namespace synthetic_dataset {
namespace nuscenes_writer_test {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

class NuScenes : public PluginTest {
 protected:
  NuScenes() : PluginTest("synthetic_dataset/NuScenes") {
    dataset_.classes = {{0, "rover"}, {2, "fork lift"}};
    for (const std::string name : {"a", "b"}) {
      ObjectInfo info;
      info.name = name;
      info.class_id = name == "a" ? 0 : 2;
      info.class_name = name == "a" ? "rover" : "fork lift";
      dataset_.objects.push_back(info);
    }
    dataset_.motions = {{"walk", 0, 4, 5.0}};
  }

  [[nodiscard]] json table(const std::string& name) const {
    return json::parse(test::readFile(folder() + "v1.0-trainval/" + name + ".json"));
  }

  [[nodiscard]] json recordOf(const std::string& name, const json& token) const {
    for (const json& each : table(name)) {
      if (each["token"] == token) return each;
    }
    ADD_FAILURE() << name << " has no " << token;
    return {};
  }
};

TEST_F(NuScenes, GivesBoxesInTheGlobalFrame) {
  SceneObject object = seen("a", {10, 20, 30, 40});
  object.cuboid_O = {{-1.0, -0.5, 0.0}, {3.0, 0.5, 2.0}};
  object.X_GO = makePose({4.0, 5.0, 6.0},
                         Eigen::Quaterniond(Eigen::AngleAxisd(M_PI_2, Eigen::Vector3d::UnitZ())));
  load({});
  runAll({scene(0, {object, seen("b", {100, 50, 20, 10})})});
  const json annotation = table("sample_annotation")[0];
  EXPECT_EQ(annotation["size"], json({1.0, 4.0, 2.0})) << "width, length, height";
  // The middle is 1 m ahead of the object, whose x is the global y, and 1 m up.
  EXPECT_NEAR(annotation["translation"][0].get<double>(), 4.0, 1e-12);
  EXPECT_NEAR(annotation["translation"][1].get<double>(), 6.0, 1e-12);
  EXPECT_NEAR(annotation["translation"][2].get<double>(), 7.0, 1e-12);
  EXPECT_NEAR(annotation["rotation"][0].get<double>(), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(annotation["rotation"][3].get<double>(), std::sqrt(0.5), 1e-12);
  EXPECT_EQ(annotation["num_lidar_pts"], 30 * 40);
  EXPECT_EQ(annotation["visibility_token"], "4");
  const json instance = recordOf("instance", annotation["instance_token"]);
  EXPECT_EQ(recordOf("category", instance["category_token"])["name"], "rover");
}

TEST_F(NuScenes, PutsTheEgoFrameWhereTheCameraIs) {
  load({});
  runAll({scene(0, {seen("a", {10, 20, 30, 40})})});
  // The camera looks along the global z: with x ahead, y left and z up, that is a turn.
  const json ego = table("ego_pose")[0];
  const Eigen::Quaterniond q(ego["rotation"][0].get<double>(), ego["rotation"][1].get<double>(),
                             ego["rotation"][2].get<double>(), ego["rotation"][3].get<double>());
  EXPECT_LT((q * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT((q * Eigen::Vector3d::UnitZ() + Eigen::Vector3d::UnitY()).norm(), 1e-12);
  const json sensor = table("calibrated_sensor")[0];
  EXPECT_EQ(sensor["rotation"], json({0.5, -0.5, 0.5, -0.5})) << "as nuScenes' own front camera";
  EXPECT_EQ(sensor["camera_intrinsic"],
            json({{500.0, 0.0, 320.0}, {0.0, 500.0, 240.0}, {0.0, 0.0, 1.0}}));
}

TEST_F(NuScenes, ChainsSamplesAndTracks) {
  load({});
  runAll({scene(0, {seen("a", {10, 20, 30, 40}), object("b")}),
          scene(1, {object("a"), seen("b", {10, 20, 30, 40})}),
          scene(2, {seen("a", {10, 20, 30, 40}), object("b")})});
  const json samples = table("sample");
  ASSERT_EQ(samples.size(), 3U);
  EXPECT_EQ(samples[0]["prev"], "");
  EXPECT_EQ(samples[0]["next"], samples[1]["token"]);
  EXPECT_EQ(samples[2]["prev"], samples[1]["token"]);
  const json annotations = table("sample_annotation");
  ASSERT_EQ(annotations.size(), 3U);
  EXPECT_EQ(annotations[0]["next"], annotations[2]["token"]) << "of the same object";
  EXPECT_EQ(annotations[1]["next"], "");
  EXPECT_EQ(table("instance")[0]["nbr_annotations"], 2);
  const json of_split = table("scene")[0];
  EXPECT_EQ(of_split["nbr_samples"], 3);
  EXPECT_EQ(of_split["description"], "train, walk");
}

TEST_F(NuScenes, HasOneAnnotationOfWhatSeveralCamerasSee) {
  int made = 0;
  const std::vector<Scene> scenes = ofTwoCamerasAndSplits([&](std::int64_t index) {
    SceneObject one = seen("a", {10, 20, 30, 40});
    if (made++ % 2 == 0) one.pixels.visible = 360;  // of 1200
    return scene(index, {one});
  });
  load({});
  runAll(scenes);
  const json annotations = table("sample_annotation");
  ASSERT_EQ(annotations.size(), 2U);
  EXPECT_EQ(annotations[0]["visibility_token"], "4") << "the greatest of both";
  EXPECT_EQ(annotations[0]["num_lidar_pts"], 360 + 1200);
  EXPECT_EQ(annotations[0]["next"], "") << "the other one is in another split";
  EXPECT_EQ(table("image_annotations").size(), 4U);
  EXPECT_EQ(table("sample_data")[1]["filename"], "samples/CAM_RIGHT/right_00000000.jpg");
}

class NuScenesWithLidar : public NuScenes {
 protected:
  NuScenesWithLidar() { dataset_.lidars = {{"top", "top_link"}}; }

  /// The cloud has a point of the world, then two of each object.
  Scene ofBoth(std::int64_t index) {
    SceneObject fork_lift = hidden(object("b"));
    fork_lift.instance = 2;
    fork_lift.class_id = 1;
    return withCloud(scene(index, {seen("a", {10, 20, 30, 40}), fork_lift}));
  }

  [[nodiscard]] std::string bytesOf(const json& filename) const {
    return test::readFile(folder() + filename.get<std::string>());
  }
};

TEST_F(NuScenesWithLidar, HasItsPointsInNuScenesFrame) {
  load({});
  runAll({ofBoth(0)});
  const json sensor = table("sensor").back();
  EXPECT_EQ(sensor["channel"], "LIDAR_TOP");
  const json data = table("sample_data").back();
  EXPECT_EQ(data["filename"], "samples/LIDAR_TOP/00000000.pcd.bin");
  const std::string bytes = bytesOf(data["filename"]);
  ASSERT_EQ(bytes.size(), 5U * 5U * sizeof(float));
  std::array<float, 10> numbers{};
  std::memcpy(numbers.data(), bytes.data(), sizeof numbers);
  // Its second point is 1.25 m ahead of the scanner and 1 m to its left.
  EXPECT_THAT(std::vector<float>(numbers.begin() + 5, numbers.end()),
              ElementsAre(-1.0F, 1.25F, 0.5F, 127.5F, 0.0F));
  const json calibrated = recordOf("calibrated_sensor", data["calibrated_sensor_token"]);
  const json& q = calibrated["rotation"];
  const Eigen::Quaterniond R_EN(q[0].get<double>(), q[1].get<double>(), q[2].get<double>(),
                                q[3].get<double>());
  EXPECT_LT((R_EN * Eigen::Vector3d(-1.0, 1.25, 0.5) - Eigen::Vector3d(1.25, 1.0, 0.5)).norm(),
            1e-9);
}

TEST_F(NuScenesWithLidar, HasACategoryOfEachPoint) {
  dataset_.world_classes = {"rover", "wall"};
  load({});
  runAll({ofBoth(0)});
  std::map<std::string, int> numbers;
  for (const json& each : table("category")) numbers[each["name"]] = each["index"];
  EXPECT_THAT(numbers, ElementsAre(Pair("fork lift", 2), Pair("noise", 0), Pair("rover", 1),
                                   Pair("wall", 3)));
  const json lidarseg = table("lidarseg")[0];
  EXPECT_EQ(lidarseg["sample_data_token"], table("sample_data").back()["token"]);
  EXPECT_EQ(bytesOf(lidarseg["filename"]), std::string("\0\1\1\2\2", 5));
}

TEST_F(NuScenesWithLidar, AnnotatesWhatNoCameraSeesButTheLidarMeets) {
  load({});
  runAll({ofBoth(0)});
  const json annotations = table("sample_annotation");
  ASSERT_EQ(annotations.size(), 2U);
  EXPECT_EQ(annotations[0]["num_lidar_pts"], 2) << "points, not pixels";
  EXPECT_EQ(annotations[1]["num_lidar_pts"], 2);
  EXPECT_EQ(annotations[1]["visibility_token"], "1");
  EXPECT_EQ(table("image_annotations").size(), 1U);
}

TEST_F(NuScenesWithLidar, LeavesOutWhatHasTooFewPoints) {
  load({{"min_points", 3}, {"lidarseg", false}});
  runAll({ofBoth(0)});
  EXPECT_THAT(table("sample_annotation"), IsEmpty());
  EXPECT_THAT(table("image_annotations"), IsEmpty());
  EXPECT_FALSE(std::filesystem::exists(folder() + "v1.0-trainval/lidarseg.json"));
}

TEST_F(NuScenesWithLidar, MayBeWrittenWithoutIt) {
  load({{"lidar", "none"}});
  runAll({ofBoth(0)});
  EXPECT_EQ(table("sensor").size(), 1U);
  EXPECT_EQ(table("sample_annotation")[0]["num_lidar_pts"], 30 * 40);
}

TEST_F(NuScenesWithLidar, HasSweepsBetweenKeyframes) {
  load({{"keyframe_every", 2}});
  runAll({ofBoth(0), ofBoth(1), ofBoth(2), ofBoth(3)});
  const json samples = table("sample");
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[0]["next"], samples[1]["token"]);
  EXPECT_EQ(table("scene")[0]["nbr_samples"], 2);
  std::vector<json> of_lidar;
  for (const json& each : table("sample_data")) {
    if (each["fileformat"] == "pcd") of_lidar.push_back(each);
  }
  ASSERT_EQ(of_lidar.size(), 4U);
  const std::vector<std::string> files = {
      "samples/LIDAR_TOP/00000000.pcd.bin", "sweeps/LIDAR_TOP/00000001.pcd.bin",
      "samples/LIDAR_TOP/00000002.pcd.bin", "sweeps/LIDAR_TOP/00000003.pcd.bin"};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(of_lidar[i]["filename"], files[i]);
    EXPECT_EQ(of_lidar[i]["is_key_frame"], i % 2 == 0);
    EXPECT_EQ(of_lidar[i]["prev"], i > 0 ? of_lidar[i - 1]["token"] : json(""));
    EXPECT_EQ(of_lidar[i]["next"], i < 3 ? of_lidar[i + 1]["token"] : json(""));
    EXPECT_EQ(of_lidar[i]["sample_token"], samples[i == 0 ? 0 : 1]["token"]);
    EXPECT_EQ(bytesOf(of_lidar[i]["filename"]).size(), 5U * 5U * sizeof(float));
    EXPECT_EQ(recordOf("ego_pose", of_lidar[i]["ego_pose_token"])["timestamp"],
              of_lidar[i]["timestamp"]);
  }
  EXPECT_TRUE(std::filesystem::exists(folder() + "sweeps/CAM_FRONT/00000001.jpg"));
}

TEST_F(NuScenesWithLidar, AnnotatesKeyframesAlone) {
  load({{"keyframe_every", 2}});
  runAll({ofBoth(0), ofBoth(1), ofBoth(2), ofBoth(3)});
  const json annotations = table("sample_annotation");
  ASSERT_EQ(annotations.size(), 4U) << "two objects in two samples";
  EXPECT_EQ(annotations[0]["next"], annotations[2]["token"]);
  EXPECT_EQ(annotations[2]["prev"], annotations[0]["token"]);
  EXPECT_EQ(table("instance")[0]["nbr_annotations"], 2);
  EXPECT_EQ(table("image_annotations").size(), 2U);
  EXPECT_EQ(table("lidarseg").size(), 2U);
}

TEST_F(NuScenes, BeginsEachMotionWithAKeyframe) {
  dataset_.motions = {{"walk", 0, 3, 5.0}, {"run", 3, 2, 5.0}};
  load({{"keyframe_every", 2}});
  const auto isKey = [&](std::int64_t index) {
    return filesOf(scene(index, {})).begin()->first.rfind("samples/", 0) == 0;
  };
  EXPECT_THAT(std::vector<bool>({isKey(0), isKey(1), isKey(2), isKey(3), isKey(4)}),
              ElementsAre(true, false, true, true, false));
}

TEST_F(NuScenes, RefusesKeyframesThatCannotBe) {
  dataset_.splits = {{"train", 8}, {"val", 2}};
  load({{"keyframe_every", 3}});
  EXPECT_THAT(parameters_.errors(),
              ElementsAre(HasSubstr("it should be 2 at most, the instants of val")));
  dataset_.splits.clear();
  dataset_.motions = {{"", 0, 4, 0.0}};
  load({{"keyframe_every", 3}});
  EXPECT_THAT(parameters_.errors(), ElementsAre(HasSubstr("placed at random")));
}

/// nuscenes-devkit, python-sdk/nuscenes/utils/splits.py.
TEST_F(NuScenes, CallsScenesByTheNamesThatTheDevkitListsForTheirSplit) {
  dataset_.motions = {{"walk", 0, 2, 5.0}, {"run", 2, 2, 5.0}};
  dataset_.splits = {{"train", {}}, {"val", {}}, {"spare", {}}, {"test", {}}};
  const auto name = [&](std::int64_t sequence) { return nuscenes::sceneName(dataset_, sequence); };
  EXPECT_EQ(name(0), "scene-0001");
  EXPECT_EQ(name(1), "scene-0002");
  EXPECT_EQ(name(2), "scene-0003");
  EXPECT_EQ(name(3), "scene-0012");
  EXPECT_EQ(name(4), "scene-0004") << "all but val and test may be trained on";
  EXPECT_EQ(name(5), "scene-0005");
  EXPECT_EQ(name(6), "scene-0077");
  EXPECT_EQ(name(7), "scene-0078");
  dataset_.motions.assign(150, {"walk", 0, 2, 5.0});
  EXPECT_EQ(nuscenes::sceneNameProblem(dataset_), std::nullopt);
  EXPECT_EQ(name(2 * 150 - 1), "scene-1073");
  EXPECT_EQ(name(4 * 150 - 1), "scene-1043");
}

TEST_F(NuScenes, RefusesMoreScenesThanTheDevkitHasNamesFor) {
  dataset_.motions.assign(151, {"walk", 0, 2, 5.0});
  EXPECT_NO_THROW(load({}));
  dataset_.splits = {{"train", {}}, {"val", {}}};
  EXPECT_THAT(*nuscenes::sceneNameProblem(dataset_),
              HasSubstr("found 151 nuScenes scenes for val"));
  load({});
  EXPECT_THAT(parameters_.errors(), ElementsAre(HasSubstr("found 151 nuScenes scenes for val")));
}

TEST_F(NuScenes, RefusesCamerasWhoseCalibrationChanges) {
  dataset_.cameras[0].intrinsics_vary = true;
  EXPECT_THROW(load({}), std::exception);
}

}  // namespace nuscenes_writer_test
}  // namespace synthetic_dataset
