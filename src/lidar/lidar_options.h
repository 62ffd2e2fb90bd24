#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::lidar {

/// How a scanner sends its rays, and how it measures those that come back. Angles are in the
/// scanner's frame: x forward, y left, z up.
struct LidarModel {
  std::vector<double> elevations;       ///< of each ring above the x-y plane [rad]
  std::vector<double> azimuth_offsets;  ///< of each ring, from x to y [rad]; empty: all 0
  std::vector<double> firing_times;     ///< of each ring within a column [s]; empty: all 0

  double rate = 10.0;                   ///< turns per second [Hz]
  int columns = 1024;                   ///< per sweep
  std::optional<double> column_period;  ///< [s]; `columns` then follow from the rate
  double first_azimuth = 0.0;           ///< where a sweep begins, from x to y [rad]
  double last_azimuth = 0.0;            ///< where it ends; less than the first: clockwise

  double min_range = 0.0;    ///< [m]; rays begin there
  double max_range = 100.0;  ///< [m]
  double resolution = 0.0;   ///< measured ranges are multiples of it [m]; 0: exact
  double noise = 0.0;        ///< standard deviation of measured ranges [m]
  double dropout = 0.0;      ///< fraction of returns that are lost, at any range

  /// The range up to which a surface that reflects a tenth of the light is seen at normal incidence
  /// [m]; for other surfaces it scales with the square root of their intensity. None: everything up
  /// to max_range is seen.
  std::optional<double> reach_at_tenth;
};

/// The names of the scanners that are built in, such as "VLP-16".
[[nodiscard]] std::vector<std::string> modelNames();

/// The model of a scanner according to its maker's data sheet; nothing for an unknown name.
[[nodiscard]] std::optional<LidarModel> modelOf(const std::string& name);

/// Settings that override a scanner's model; none: the model's value.
struct LidarChanges {
  std::optional<double> rate;
  std::optional<double> min_range;
  std::optional<double> max_range;
  std::optional<double> resolution;
  std::optional<double> noise;
  std::optional<double> dropout;
  std::optional<double> reach_at_tenth;  ///< 0: no limit

  void apply(LidarModel& model) const;
};

/// The largest number of rays per column, and of columns.
constexpr int kMostRings = 512;
constexpr int kMostColumns = 65535;
constexpr double kFarthestSeen = 1e5;  ///< [m]

/// `count` evenly spaced angles, including the first and the last.
[[nodiscard]] std::vector<double> evenAngles(int count, double first, double last);

/// Whether the sweep is a full turn: the column after the last would be the first again.
[[nodiscard]] bool isWholeTurn(const LidarModel& model);

/// The number of columns of a sweep.
[[nodiscard]] int columnsOf(const LidarModel& model);

/// How long a sweep takes.
[[nodiscard]] Duration sweepTime(const LidarModel& model);

/// Whether this build has the library that casts rays.
[[nodiscard]] bool canCastRays();

/// What to do if it does not, for messages.
[[nodiscard]] std::string howToCastRays();

/// Which recorded clouds a lidar has, and how their points are labelled.
struct RecordedSweepOptions {
  std::string topic;              ///< of the bag
  std::int64_t every = 1;         ///< every n-th cloud is a scene, if no pictures give the times
  Duration time_offset{0};        ///< added to stamps of the scanner's clock to give TF's
  double tolerance = 0.1;         ///< how far from a surface points of it may be [m]
  double full_intensity = 255.0;  ///< the recorded value that means an intensity of 1

  /// Largest difference between a scene's stamp and the middle of its cloud's times.
  Duration longest_distance = std::chrono::milliseconds(60);
};

/// The suffix of a lidar's default frame, after the lidar's name.
constexpr const char* kOwnFrame = "/lidar_link";

/// A scanner of the run.
struct LidarOptions {
  std::string name;
  std::string group;                  ///< its parameters' full name, for messages
  std::string frame;                  ///< its own; empty: that of its recorded clouds
  std::optional<Pose> X_GS;           ///< its fixed pose; with `on`, in that object's frame
  std::optional<std::string> on;      ///< the object that it is mounted on
  std::optional<std::string> sensor;  ///< the world's sensor that it is: "model::link::sensor"
  LidarModel model;                   ///< if it is not a `sensor`; includes all changes
  LidarChanges changes;
  std::optional<RecordedSweepOptions> recorded;  ///< if set, no rays are cast
};

}  // namespace synthetic_dataset::lidar
