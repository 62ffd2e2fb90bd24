/// Models made by others: those of the Gazebo model library and robots' URDF files.

#include <map>
#include <string>

#include <gtest/gtest.h>

#include "programs/gallery/model_gallery.h"
#include "reference/reference_folder.h"
#include "run/setup/package_index.h"
#include "world/files/model_folders.h"

namespace synthetic_dataset {
namespace gazebo_models_test {

struct Expected {
  std::size_t visuals;
  std::size_t triangles;
  std::size_t textures;
};

/// The contents of each model, all or some of whose files are there.
const std::map<std::string, Expected> kExpected = {
    {"gazebo/arm_part", {1, 392, 1}},
    {"gazebo/bookshelf", {7, 84, 1}},
    {"gazebo/cabinet", {6, 72, 1}},
    {"gazebo/cafe_table", {1, 68, 2}},
    {"gazebo/cardboard_box", {1, 32, 1}},
    {"gazebo/checkerboard_plane", {1, 2, 1}},
    {"gazebo/cinder_block", {1, 84, 1}},
    {"gazebo/construction_barrel", {1, 1184, 1}},
    {"gazebo/construction_cone", {1, 166, 1}},
    {"gazebo/demo_joint_types", {18, 6348, 4}},
    {"gazebo/drc_practice_4x4x20", {1, 152, 1}},
    {"gazebo/drc_practice_angled_barrier_45", {0, 0, 0}},
    {"gazebo/drc_practice_handle_wheel_valve", {1, 12920, 1}},
    {"gazebo/drc_practice_handle_wheel_valve_wall", {2, 16200, 2}},
    {"gazebo/drc_practice_valve_wall", {1, 3280, 1}},
    {"gazebo/fire_hydrant", {1, 610, 1}},
    {"gazebo/gear_part", {1, 192, 1}},
    {"gazebo/ground_plane", {1, 2, 0}},
    {"gazebo/hammer", {1, 4550, 0}},
    {"gazebo/hatchback", {1, 788, 2}},
    {"gazebo/house_3", {1, 1632, 1}},
    {"gazebo/jersey_barrier", {1, 432, 1}},
    {"gazebo/pioneer2dx", {4, 6468, 0}},
    {"gazebo/postbox", {1, 692, 1}},
    {"gazebo/ragdoll", {24, 48024, 0}},
    {"gazebo/robocup_3Dsim_field", {5, 10, 1}},
    {"gazebo/stop_sign", {1, 22, 1}},
    {"gazebo/submarine", {6, 624, 0}},
    {"gazebo/sun", {0, 0, 0}},
    {"gazebo/table_marble", {1, 1564, 1}},
    {"gazebo/textured_shapes", {3, 5340, 1}},
    {"gazebo/warehouse_robot", {1, 624, 1}},
    {"urdf/husky/husky.urdf", {9, 35902, 0}},
    {"urdf/racecar/racecar.urdf", {9, 12818, 0}},
    {"urdf/racecar/racecar_differential.urdf", {9, 12898, 1}},
};

TEST(GazeboModels, LoadWithAllTheirPartsAndTextures) {
  const std::filesystem::path folder = test::referenceFolder() / "models";
  const auto models = world::findModels(folder);
  const world::ResourceFinder finder(programs::modelFolders(folder, models),
                                     run::rosPackageFinder());
  std::size_t loaded = 0;
  for (const auto& model : models) {
    const std::string name = std::filesystem::relative(model, folder).string();
    const programs::GalleryEntry entry = programs::portrayModel(model, name, finder, {64, 48});
    const auto expected = kExpected.find(name);
    EXPECT_EQ(entry.error.empty(), expected != kExpected.end()) << name << ": " << entry.error;
    if (!entry.error.empty() || expected == kExpected.end()) continue;
    ++loaded;
    EXPECT_EQ(entry.counts.visuals, expected->second.visuals) << name;
    EXPECT_EQ(entry.counts.triangles, expected->second.triangles) << name;
    EXPECT_EQ(entry.counts.textures, expected->second.textures) << name;
    EXPECT_EQ(entry.picture.empty(), expected->second.triangles == 0) << name;
  }
  EXPECT_EQ(loaded, kExpected.size()) << "of " << models.size();
}

}  // namespace gazebo_models_test
}  // namespace synthetic_dataset
