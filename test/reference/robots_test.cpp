/// Robots made by others, in recordings made by others.

#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/yaml_value.h"
#include "reference/reference_folder.h"
#include "run/generator.h"
#include "support/temporary_folder.h"
#include "support/writers/plugin_environment.h"
#include "world/world_loader.h"

namespace synthetic_dataset {
namespace robots_test {

std::string modelFile(const std::string& name) {
  return (test::referenceFolder() / "models/urdf" / name).string();
}

struct Counts {
  std::size_t links = 0, visuals = 0, moving = 0;
};

Counts countsOf(const std::string& file) {
  const world::ResourceFinder finder({}, nullptr);
  const world::Model model = world::loadModel(modelFile(file), "robot", finder);
  Counts counts;
  counts.links = model.links.size();
  for (const world::Link& link : model.links) {
    counts.visuals += link.visuals.size();
    counts.moving += link.moving_joint.empty() ? 0 : 1;
  }
  return counts;
}

TEST(Robots, AHuskyHasAllItsLinks) {
  const Counts husky = countsOf("husky/husky.urdf");
  EXPECT_EQ(husky.links, 11U);
  EXPECT_EQ(husky.visuals, 9U);
  EXPECT_EQ(husky.moving, 4U);
}

TEST(Robots, ARacecarHasAllItsLinks) {
  const Counts racecar = countsOf("racecar/racecar.urdf");
  EXPECT_EQ(racecar.links, 13U);
  EXPECT_EQ(racecar.moving, 6U);
}

constexpr char kWorld[] = R"(<sdf version="1.6"><world name="yard">
<scene><ambient>0.5 0.5 0.5 1</ambient><background>0.6 0.75 0.9 1</background></scene>
<light name="sun" type="directional"><cast_shadows>true</cast_shadows>
  <direction>0.4 0.5 -1</direction><diffuse>0.9 0.9 0.9 1</diffuse></light>
<model name="floor"><static>true</static><link name="body">
  <visual name="slab"><pose>0 0 -0.115 0 0 0</pose><geometry><box><size>60 60 0.2</size></box></geometry>
    <material><diffuse>0.55 0.5 0.45 1</diffuse></material></visual></link></model>
</world></sdf>
)";

constexpr char kCamera[] = R"(image_width: 640
image_height: 480
camera_matrix: {rows: 3, cols: 3, data: [420, 0, 319.5, 0, 420, 239.5, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}
)";

/// Scenes of the Jackal's recording with another robot in its place, seen from beside its start.
run::RunSummary replay(const test::TemporaryFolder& folder, const std::string& model,
                       const std::string& output) {
  const std::string text =
      "bag_file: " + (test::referenceFolder() / "bags/jackal.bag").string() +
      "\nsimulated_rate: 1\nduration: 20\nworld: " + folder.write("yard.world", kWorld).string() +
      "\ncamera: {info_file: " + folder.write("camera.yaml", kCamera).string() +
      ", pose: [2.2, 0.8, 1.3, -0.7051, -0.42115, 0.29254, 0.48978]}\nrobot_list: jackal\njackal: "
      "{class: robot, id: 1, keypoints: {farthest_points: 9}, model: " +
      modelFile(model) + "}\noutput_folder: " + output +
      "\nbackground_subtractor: {history_length: 1, var_threshold: 16.0}\nyolo: {main_list: "
      "list.txt}\nbounding_shape: {output_frame: map}\n";
  run::Reporter reporter;
  run::Generator generator(base::parseYaml(text, "test"), reporter, {test::pluginXml()});
  return generator.run();
}

TEST(Robots, ReplayAJackalsRun) {
  test::preparePluginEnvironment();
  const test::TemporaryFolder folder;
  const char* kept = std::getenv("SYNTHETIC_DATASET_KEEP");
  const std::filesystem::path out = kept != nullptr ? std::filesystem::path(kept) : folder / "out";
  for (const std::string model : {"husky/husky.urdf", "racecar/racecar.urdf"}) {
    const run::RunSummary summary = replay(folder, model, (out / model).string());
    EXPECT_GE(summary.scenes, 19) << model;
    EXPECT_GT(summary.objects.at(0).scenes_in_view, 0) << model;
  }
}

}  // namespace robots_test
}  // namespace synthetic_dataset
