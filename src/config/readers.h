#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "config/config.h"
#include "lidar/lidar_options.h"
#include "motion/motion_options.h"
#include "output/output_options.h"
#include "randomize/appearance/randomize_options.h"
#include "randomize/placement/placement_options.h"
#include "render/sensor/sensor_options.h"
#include "scene/camera_options.h"
#include "scene/object_options.h"
#include "scene/scene_options.h"
#include "synthetic_dataset/parameters.h"
#include "synthetic_dataset/pose.h"

/// The readers of the groups of settings, with a source file for each. What is wrong is noted in
/// the parameters, and a harmless value is used instead. By reading its settings, a reader also
/// declares their names, defaults, ranges and choices (Parameters::declarations()).
namespace synthetic_dataset::config {

/// Reads where scenes come from, except for the group `placement`.
[[nodiscard]] motion::MotionOptions readMotion(Parameters& root);

/// Reads a group's `volume: {min: [x, y, z], max: [x, y, z]}`, which is mandatory.
[[nodiscard]] randomize::Volume readVolume(Parameters group);

/// Reads the group `placement`.
[[nodiscard]] randomize::PlacementOptions readPlacement(Parameters root);

/// Reads the camera of the group `camera`, or those of the group `cameras`, in alphabetical order.
[[nodiscard]] std::vector<scene::CameraOptions> readCameras(Parameters root);

/// The names of a group's entries that are valid folder names; others are noted and ignored.
[[nodiscard]] std::vector<std::string> folderNames(Parameters& group);

/// Reads the lidars of the group `lidars`, in alphabetical order.
/// @param cameras  whose frames they must not share
[[nodiscard]] std::vector<lidar::LidarOptions> readLidars(
    Parameters root, const std::vector<scene::CameraOptions>& cameras);

/// Whether a topic's name says that its pictures are rectified, as image_proc names its topics:
/// image_rect, image_rect_color/compressed.
[[nodiscard]] bool isRectifiedTopic(const std::string& topic);

/// Reads a camera's group `sample`; nullopt if there is none.
/// @param camera  its group
[[nodiscard]] std::optional<randomize::CameraSampling> readCameraSampling(Parameters camera);

/// Reads a camera's `depth_noise`; without it, depth is exact.
/// @param camera  the group above it
[[nodiscard]] render::DepthNoise readDepthNoise(Parameters& camera);

/// Reads the group `randomize`, in which everything is optional.
[[nodiscard]] randomize::Randomization readRandomization(Parameters root);

/// Reads `background` of `randomize`: a colour, or a group with `colour`, `pictures` and the
/// settings of the pictures.
[[nodiscard]] randomize::BackgroundRandomization readBackground(Parameters randomize);

/// Reads the group `room` of `randomize`; nullopt if there is none.
[[nodiscard]] std::optional<randomize::RoomOptions> readRoom(Parameters randomize);

/// Reads the group `distractors` of `randomize`; nullopt if there is none.
[[nodiscard]] std::optional<randomize::DistractorOptions> readDistractors(Parameters randomize);

/// Reads `twin`: how recorded pictures are labelled. Settings that contradict them are noted.
/// @param scenes  with motion, cameras and randomisation already read
[[nodiscard]] scene::RecordedImageOptions readTwinOptions(Parameters root,
                                                          const scene::SceneOptions& scenes);

/// Whether a group of settings has this name. No object can have such a name, as its own group
/// would be called the same.
[[nodiscard]] bool isSettingGroup(const std::string& name);

/// Reads an object's `pose`, if it has one: it then stands still in the world and follows no frame.
/// @return whether it has one
[[nodiscard]] bool readStanding(Parameters& group, scene::ObjectOptions& object);

/// Notes what is wrong with `world_objects`. If the world can be read, its objects are written into
/// `robot_list` before the settings are read (run/setup/world_objects.h).
void checkWorldObjects(Parameters& root);

/// Reads `robot_list` and the group of each object in it. It may be left out if there is
/// `world_objects`.
[[nodiscard]] std::vector<scene::ObjectOptions> readObjects(Parameters root);

/// Appends the labelled distractors to the objects, in the order of their numbers.
void addLabelledDistractors(Parameters root,
                            const std::optional<randomize::DistractorOptions>& distractors,
                            std::vector<scene::ObjectOptions>& objects);

/// Reads a class's name or an object's id for label files: a text or a number.
[[nodiscard]] std::string readLabel(Parameters group, const std::string& name);

/// Reads `masks` and `background_subtractor`.
[[nodiscard]] label::MaskOptions readMasks(Parameters root);

/// Reads `labels`.
[[nodiscard]] label::LabelOptions readLabels(Parameters root);

/// Reads `split`.
[[nodiscard]] SplitConfig readSplit(Parameters root);

/// Reads `classes` and gives each object its class's number.
///
/// Without `classes`, a class that is a whole number keeps it, and the others get the remaining
/// numbers, from 0 on, in alphabetical order.
/// @return all classes in the order of their numbers
[[nodiscard]] std::vector<ClassConfig> readClasses(Parameters root,
                                                   std::vector<scene::ObjectOptions>& objects);

/// Reads `world_classes`.
/// @param classes  of objects, whose names must differ
[[nodiscard]] scene::WorldClasses readWorldClasses(Parameters root,
                                                   const std::vector<ClassConfig>& classes);

/// Reads `output_folder`, `if_exists`, `sync`, `shard` and `image`.
[[nodiscard]] output::StoreOptions readOutput(Parameters root);

/// Reads `processes`; 1 if there is a shard.
[[nodiscard]] int readProcesses(Parameters root, bool is_shard);

/// Reads `only_scenes: [17]`, or one number.
[[nodiscard]] std::set<std::int64_t> readOnlyScenes(Parameters root);

/// Reads `writers` (by default nn_data_collection's three) and the output folder of each.
/// @param output_folder  of the run; empty if it has none
[[nodiscard]] std::vector<output::WriterOptions> readWriters(Parameters root,
                                                             const std::string& output_folder);

/// The deepest folder common to all writers' folders, for the manifest.
[[nodiscard]] std::string commonFolder(const std::vector<output::WriterOptions>& writers);

}  // namespace synthetic_dataset::config
