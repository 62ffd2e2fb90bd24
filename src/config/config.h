#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "config/camera_config.h"
#include "config/placement_config.h"
#include "config/randomization.h"
#include "synthetic_dataset/parameters.h"
#include "synthetic_dataset/pose.h"

/// Every setting of a run as a value, with its default; config/params.yaml documents each.
namespace synthetic_dataset::config {

/// Which TF frame each link of an object has.
struct LinkFrames {
  std::string pattern = "{object}/{link}";     ///< for all links
  std::map<std::string, std::string> by_link;  ///< where not empty: these frames, and no others
};

struct ObjectConfig {
  std::string name;
  std::string class_text;            ///< `class` as text: a name, or a class's number
  std::string class_name;            ///< of its class in Config::classes
  int class_id = 0;                  ///< of its class in Config::classes
  std::string id;                    ///< `id` as text
  bool takes_part = true;            ///< in this motion, where its frame is
  bool is_distractor = false;        ///< put somewhere now and then; these come last
  std::string frame;                 ///< `frame`, else "<name>/<frame_id>"
  LinkFrames link_frames;            ///< of an articulated model
  std::optional<std::string> model;  ///< its model, the URI of it or its text; none: the world's
                                     ///< model of its name
  std::vector<Eigen::Vector3d> keypoints_O;
  std::vector<std::string> keypoint_names;           ///< none: numbers
  std::vector<std::array<std::size_t, 2>> skeleton;  ///< pairs of keypoints, from 0
  int farthest_points = 0;  ///< so many keypoints are chosen on the model instead; 0: as given
  std::vector<Eigen::Vector3d> bounding_shape_O;  ///< none: the model's own box
  std::optional<double> safety_radius;  ///< kept free round it when it is placed [m]; none: its own
};

/// Where objects and frames come from.
enum class MotionSource {
  kBag,        ///< a recording's TF
  kPlacement,  ///< put somewhere at random, scene by scene
};

struct MotionConfig {
  MotionSource source = MotionSource::kBag;
  std::vector<std::string> bag_files;  ///< of kPlacement: for recorded maps and calibrations
  std::int64_t scenes = 0;             ///< of kPlacement: how many times a picture is taken
  double rate = 30.0;                  ///< [Hz]
  double start_offset = 0.0;           ///< [s]
  std::optional<double> duration;      ///< [s]
  std::optional<double> max_tf_gap;    ///< [s]
};

/// What becomes of a world with a mesh, picture or model that is missing.
enum class OnMissingAsset { kError, kWarn };

struct WorldConfig {
  std::string file;
  std::vector<std::string> model_folders;
  OnMissingAsset on_missing_asset = OnMissingAsset::kError;
};

/// How masks are found.
enum class MaskMethod {
  kMog2,   ///< by background subtraction, as in the paper
  kExact,  ///< in the renderer's identifiers
};

struct MaskConfig {
  MaskMethod method = MaskMethod::kExact;
  bool method_is_given = false;  ///< else it follows from `background_subtractor`
  int history_length = 100;
  double var_threshold = 500.0;
  bool detect_shadows = false;
  bool clean = true;
};

/// Which objects get labels.
struct LabelConfig {
  double min_visibility = 0.0;       ///< 0 .. 1; 0: no threshold
  std::int64_t min_pixels = 0;       ///< visible ones; 0: no threshold
  double keypoint_tolerance = 0.01;  ///< [m] behind what is seen, and still visible

  [[nodiscard]] bool hasThresholds() const { return min_visibility > 0.0 || min_pixels > 0; }
};

enum class SplitBy {
  kBlocks,  ///< the first scenes, those after them, the last
  kScenes,  ///< drawn at random
};

struct SplitConfig {
  std::vector<std::pair<std::string, double>> shares;  ///< name, share > 0; empty: no splits
  SplitBy by = SplitBy::kBlocks;
};

struct ClassConfig {
  int id = 0;
  std::string name;
};

struct PhysicsConfig {
  double step = 0.004;              ///< [s]
  double contact_tolerance = 0.01;  ///< [m]
  double settle = 0.0;              ///< [s] simulated before the first scene
};

struct RenderingConfig {
  int samples = 4;
  int shadow_map_size = 2048;
  double shadow_distance = 50.0;  ///< [m]
  bool reuse = true;
};

/// What becomes of a dataset that is already there.
enum class IfExists {
  kResume,     ///< gone on with
  kOverwrite,  ///< replaced
  kError,      ///< left alone, and told of
};

/// How hard the run waits for the disk.
enum class Sync { kOff, kScene, kBatch };

/// The part of a run's scenes that this one makes.
struct ShardConfig {
  std::int64_t index = 0;  ///< 0 .. count - 1
  std::int64_t count = 1;
};

struct OutputConfig {
  std::string folder;  ///< absolute
  IfExists if_exists = IfExists::kResume;
  Sync sync = Sync::kBatch;
  std::optional<ShardConfig> shard;
  int processes = 1;                   ///< that make the scenes; 1 where `shard` is set
  std::set<std::int64_t> only_scenes;  ///< by the numbers in their files' names; empty: all
  int png_compression = 1;
  int jpeg_quality = 95;
};

struct WriterConfig {
  std::string name;
  std::string type;
  std::string output_folder;  ///< absolute, ending in `/`
  Parameters parameters;
};

struct Config {
  /// Whether scenes are placed at random, not recorded.
  [[nodiscard]] bool isPlaced() const { return motion.source == MotionSource::kPlacement; }

  /// How many objects are followed or placed, and no distractors.
  [[nodiscard]] std::size_t robotCount() const {
    std::size_t count = 0;
    for (const ObjectConfig& object : objects) count += object.is_distractor ? 0 : 1;
    return count;
  }

  std::string global_frame = "map";
  MotionConfig motion;
  PlacementConfig placement;  ///< of MotionSource::kPlacement
  Randomization randomization;
  WorldConfig world;
  std::vector<CameraConfig> cameras;  ///< at least one
  std::vector<ObjectConfig> objects;
  std::vector<ClassConfig> classes;  ///< in the order of their numbers
  MaskConfig masks;
  LabelConfig labels;
  SplitConfig split;
  PhysicsConfig physics;
  RenderingConfig rendering;
  std::int64_t seed = 0;  ///< of all that is random
  OutputConfig output;
  std::vector<WriterConfig> writers;
};

/// Reads all settings. What is wrong is noted in `root`, with a harmless value in its place.
[[nodiscard]] Config readConfig(Parameters root);

/// One error for each parameter that nobody reads, with the name that it may have meant. Ask when
/// the writers have read theirs. Blocks of objects and writers that this run does not use are no
/// error: the original's users keep them in their files.
/// @param names  which of the root's unknownNames() are told
[[nodiscard]] std::vector<std::string> unknownParameterErrors(
    Parameters root, const std::vector<std::string>& names);

}  // namespace synthetic_dataset::config
