#include "config/motion_overlay.h"

#include <set>
#include <string>

#include <gmock/gmock.h>

#include "base/yaml_value.h"

namespace synthetic_dataset::config {
namespace motion_overlay_test {

using ::testing::Contains;
using ::testing::Not;

Value::Map yaml(const std::string& text) { return *base::parseYaml(text, "test").as<Value::Map>(); }

/// The run's settings overlaid with an entry's; both have the object `rover`.
Value::Map overlaid(const std::string& run, const std::string& own) {
  Value::Map settings = yaml(run);
  overlayMotion(settings, yaml(own), {"rover"});
  return settings;
}

TEST(OverlayMotion, MergesGroupsAndReplacesAllElse) {
  EXPECT_EQ(
      overlaid("{bag_file: [a.bag, b.bag], simulated_rate: 5, physics: {step: 0.01, settle: 1}}",
               "{bag_file: c.bag, physics: {settle: 2}}"),
      yaml("{bag_file: c.bag, simulated_rate: 5, physics: {step: 0.01, settle: 2}}"));
}

TEST(OverlayMotion, MergesGroupsWithinGroups) {
  EXPECT_EQ(overlaid("{randomize: {ambient: 0.5, lights: {sun: {intensity: 1, present: 0.5}}}}",
                     "{randomize: {lights: {sun: {intensity: 2}, lamp: {intensity: 3}}}}"),
            yaml("{randomize: {ambient: 0.5, lights: {sun: {intensity: 2, present: 0.5}, lamp: "
                 "{intensity: 3}}}}"));
}

// --- The world, which has three spellings ---

TEST(OverlayMotion, KnowsAWorldByItsFileAlone) {
  EXPECT_EQ(overlaid("{world: {file: a.world, model_folders: [m]}}", "{world: b.world}"),
            yaml("{world: {file: b.world, model_folders: [m]}}"));
}

TEST(OverlayMotion, PutsAGroupOverAWorldsFile) {
  EXPECT_EQ(overlaid("{world: a.world}", "{world: {on_missing_asset: warn}}"),
            yaml("{world: {file: a.world, on_missing_asset: warn}}"));
}

TEST(OverlayMotion, PutsItsWorldOverTheRunsWorldFile) {
  EXPECT_EQ(overlaid("{world: a.world, world_file: b.world}", "{world: c.world}"),
            yaml("{world: {file: c.world}}"));
  EXPECT_EQ(overlaid("{world: {file: a.world, model_folders: [m]}}", "{world_file: d.world}"),
            yaml("{world: {file: d.world, model_folders: [m]}}"));
}

// --- The camera ---

TEST(OverlayMotion, PutsACameraSomewhereElseInAnotherWay) {
  const std::string file = "{camera: {info_file: c.yaml, ";
  EXPECT_EQ(overlaid(file + "pose: [1]}}", "{camera: {sample: {look_at: any}}}"),
            yaml(file + "sample: {look_at: any}}}"));
  EXPECT_EQ(overlaid(file + "sample: {look_at: any, roll: 1}}}", "{camera: {pose: [2]}}"),
            yaml(file + "pose: [2]}}"));
}

TEST(OverlayMotion, MergesTwoWaysOfPlacingACameraAtRandom) {
  EXPECT_EQ(
      overlaid("{camera: {sample: {look_at: any, roll: 1}}}", "{camera: {sample: {roll: 2}}}"),
      yaml("{camera: {sample: {look_at: any, roll: 2}}}"));
}

TEST(OverlayMotion, MountsACameraThatHadAPose) {
  EXPECT_EQ(overlaid("{camera: {pose: [1], far: 9}}", "{camera: {mounted_on: rover, pose: [3]}}"),
            yaml("{camera: {mounted_on: rover, pose: [3], far: 9}}"));
  EXPECT_EQ(overlaid("{camera: {mounted_on: rover, pose: [3]}}", "{camera: {pose: [1]}}"),
            yaml("{camera: {pose: [1]}}"));
}

TEST(OverlayMotion, CalibratesACameraInAnotherWay) {
  EXPECT_EQ(overlaid("{camera: {info_file: c.yaml, pose: [1]}}", "{camera: {info_topic: /info}}"),
            yaml("{camera: {info_topic: /info, pose: [1]}}"));
  EXPECT_EQ(
      overlaid("{camera: {info_topic: /info, sensor: 'a::b::c'}}", "{camera: {info_file: c.yaml}}"),
      yaml("{camera: {info_file: c.yaml}}"));
}

TEST(OverlayMotion, MakesWayInEachOfSeveralCameras) {
  EXPECT_EQ(overlaid("{cameras: {a: {pose: [1]}, b: {pose: [2], info_file: b.yaml}}}",
                     "{cameras: {b: {sample: {look_at: all}}}}"),
            yaml("{cameras: {a: {pose: [1]}, b: {sample: {look_at: all}, info_file: b.yaml}}}"));
}

TEST(OverlayMotion, HasOneCameraInsteadOfSeveral) {
  EXPECT_EQ(overlaid("{cameras: {a: {pose: [1]}}}", "{camera: {pose: [2]}}"),
            yaml("{camera: {pose: [2]}}"));
  EXPECT_EQ(overlaid("{cameras: {a: {pose: [1]}}}", "{camera_frame_id: eye}"),
            yaml("{camera_frame_id: eye}"));
}

TEST(OverlayMotion, HasSeveralCamerasInsteadOfOne) {
  EXPECT_EQ(overlaid("{camera: {pose: [1]}, camera_frame_id: eye}", "{cameras: {a: {pose: [2]}}}"),
            yaml("{cameras: {a: {pose: [2]}}}"));
}

TEST(OverlayMotion, KeepsTheCameraBesideAnotherFrame) {
  EXPECT_EQ(overlaid("{camera: {far: 9}, camera_frame_id: eye}", "{camera_frame_id: other}"),
            yaml("{camera: {far: 9}, camera_frame_id: other}"));
  EXPECT_EQ(overlaid("{camera: {far: 9}, camera_frame_id: eye}", "{camera: {far: 8}}"),
            yaml("{camera: {far: 8}, camera_frame_id: eye}"));
}

// --- The placement ---

TEST(OverlayMotion, MergesPlacementsOfOneKind) {
  EXPECT_EQ(
      overlaid("{placement: {mode: drop, tries: 5, fall_time: 3}}", "{placement: {tries: 7}}"),
      yaml("{placement: {mode: drop, tries: 7, fall_time: 3}}"));
}

TEST(OverlayMotion, HasAPlacementOfAnotherModeAlone) {
  EXPECT_EQ(overlaid("{placement: {map: m.yaml, highest_surface: 1}}",
                     "{placement: {mode: volume, volume: {min: [0]}}}"),
            yaml("{placement: {mode: volume, volume: {min: [0]}}}"));
}

TEST(OverlayMotion, TakesAnotherMap) {
  EXPECT_EQ(overlaid("{placement: {map: m.yaml, tries: 5}}", "{placement: {map_topic: /map}}"),
            yaml("{placement: {map_topic: /map, tries: 5}}"));
  EXPECT_EQ(overlaid("{placement: {map_topic: /map, tries: 5}}", "{placement: {map: n.yaml}}"),
            yaml("{placement: {map: n.yaml, tries: 5}}"));
}

// --- Objects ---

TEST(OverlayMotion, MovesAnObjectWithAnotherFrame) {
  EXPECT_EQ(overlaid("{rover: {class: rover, frame_id: base}}", "{rover: {frame: robot_7}}"),
            yaml("{rover: {class: rover, frame: robot_7}}"));
  EXPECT_EQ(overlaid("{rover: {frame: robot_7}}", "{rover: {frame_id: base}}"),
            yaml("{rover: {frame_id: base}}"));
}

TEST(OverlayMotion, ReplacesTheLinksFramesAsAWhole) {
  // If they were merged, the run's frames would be looked up in a recording that has other ones.
  EXPECT_EQ(
      overlaid("{rover: {link_frames: {arm: a, hand: h}}}", "{rover: {link_frames: {arm: b}}}"),
      yaml("{rover: {link_frames: {arm: b}}}"));
}

TEST(OverlayMotion, KeepsTheRestOfAnObject) {
  EXPECT_EQ(overlaid("{rover: {class: rover, frame: f, link_frames: {arm: a}}}",
                     "{rover: {safety_radius: 0.5}}"),
            yaml("{rover: {class: rover, frame: f, link_frames: {arm: a}, safety_radius: 0.5}}"));
}

TEST(SettingsOfMotions, AreNoneOfTheWholeDataset) {
  for (const char* name :
       {"robot_list", "writers", "output_folder", "seed", "global_frame", "classes", "labels",
        "masks", "shard", "processes", "rendering", "motions"}) {
    EXPECT_THAT(settingsOfMotions(), Not(Contains(name)));
  }
}

}  // namespace motion_overlay_test
}  // namespace synthetic_dataset::config
