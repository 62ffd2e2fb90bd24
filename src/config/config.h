#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/parameters.h"
#include "synthetic_dataset/pose.h"

/// Every setting of a run as a value, with its default; config/params.yaml documents each.
namespace synthetic_dataset::config {

struct ObjectConfig {
  std::string name;
  std::string class_name;            ///< `class` as text
  std::string id;                    ///< `id` as text
  std::string frame;                 ///< "<name>/<frame_id>"
  std::optional<std::string> model;  ///< URI of its model; none: the world's model of its name
  std::vector<Eigen::Vector3d> keypoints_O;
  std::vector<Eigen::Vector3d> bounding_shape_O;
};

struct MotionConfig {
  std::vector<std::string> bag_files;
  double rate = 30.0;                ///< [Hz]
  double start_offset = 0.0;         ///< [s]
  std::optional<double> duration;    ///< [s]
  std::optional<double> max_tf_gap;  ///< [s]
};

struct WorldConfig {
  std::string file;
  std::vector<std::string> model_folders;
};

struct CameraConfig {
  std::string frame = "camera/optical_link";
  std::optional<std::string> info_file;
  std::optional<std::string> sensor;  ///< "model::link::sensor"
  std::optional<Pose> X_GC;
  bool rectified = false;
  double near = 0.05;   ///< [m]
  double far = 1000.0;  ///< [m]
};

struct MaskConfig {
  int history_length = 100;
  double var_threshold = 500.0;
  bool detect_shadows = false;
  bool clean = true;
};

struct PhysicsConfig {
  double step = 0.004;              ///< [s]
  double contact_tolerance = 0.01;  ///< [m]
};

struct RenderingConfig {
  int samples = 4;
  int shadow_map_size = 2048;
  double shadow_distance = 50.0;  ///< [m]
};

struct OutputConfig {
  std::string folder;  ///< absolute
  bool overwrite = false;
  int png_compression = 3;
  int jpeg_quality = 95;
};

struct WriterConfig {
  std::string name;
  std::string type;
  std::string output_folder;  ///< absolute, ending in `/`
  Parameters parameters;
};

struct Config {
  std::string global_frame = "map";
  MotionConfig motion;
  WorldConfig world;
  CameraConfig camera;
  std::vector<ObjectConfig> objects;
  MaskConfig masks;
  PhysicsConfig physics;
  RenderingConfig rendering;
  OutputConfig output;
  std::vector<WriterConfig> writers;
};

/// Reads all settings. What is wrong is noted in `root`, with a harmless value in its place.
[[nodiscard]] Config readConfig(const Parameters& root);

/// One error for each parameter that nobody reads, with the name that it may have meant. Ask when
/// the writers have read theirs. Blocks of objects and writers that this run does not use are no
/// error: the original's users keep them in their files.
[[nodiscard]] std::vector<std::string> unknownParameterErrors(const Parameters& root);

}  // namespace synthetic_dataset::config
