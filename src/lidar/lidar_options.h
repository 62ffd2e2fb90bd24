#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::lidar {

/// How a scanner sends its rays, and what it makes of those that come back. Angles in the scanner's
/// frame: x ahead, y left, z up.
struct LidarModel {
  std::vector<double> elevations;       ///< of each ring above the x-y plane [rad]
  std::vector<double> azimuth_offsets;  ///< of each ring, from x to y [rad]; none: all 0
  std::vector<double> firing_times;     ///< of each ring within a column [s]; none: all 0

  double rate = 10.0;                   ///< turns in a second [Hz]
  int columns = 1024;                   ///< of a sweep
  std::optional<double> column_period;  ///< [s]; `columns` then follow from the rate
  double first_azimuth = 0.0;           ///< where a sweep begins, from x to y [rad]
  double last_azimuth = 0.0;            ///< where it ends; less than the first: clockwise

  double min_range = 0.0;    ///< [m]; rays begin there
  double max_range = 100.0;  ///< [m]
  double resolution = 0.0;   ///< measured ranges are multiples of it [m]; 0: exact
  double noise = 0.0;        ///< standard deviation of measured ranges [m]
  double dropout = 0.0;      ///< the share of returns that get lost, wherever they come from

  /// How far away a surface is still seen that sends a tenth of the light back, met at right angles
  /// [m]; others as their intensity has it, by the square of the range. None: all up to max_range.
  std::optional<double> reach_at_tenth;
};

/// The scanners that are known by name: "VLP-16".
[[nodiscard]] std::vector<std::string> modelNames();

/// A scanner as its maker's data sheet has it; nothing for another name.
[[nodiscard]] std::optional<LidarModel> modelOf(const std::string& name);

/// What is set of a scanner beside its model; none: as that has it.
struct LidarChanges {
  std::optional<double> rate;
  std::optional<double> min_range;
  std::optional<double> max_range;
  std::optional<double> resolution;
  std::optional<double> noise;
  std::optional<double> dropout;
  std::optional<double> reach_at_tenth;  ///< 0: it sees all

  void apply(LidarModel& model) const;
};

/// The most rays of a column, and the most columns.
constexpr int kMostRings = 512;
constexpr int kMostColumns = 65535;
constexpr double kFarthestSeen = 1e5;  ///< [m]

/// So many angles at the same distance from one another, the first and the last among them.
[[nodiscard]] std::vector<double> evenAngles(int count, double first, double last);

/// Whether the first column and the one after the last are one.
[[nodiscard]] bool isWholeTurn(const LidarModel& model);

/// The number of columns of a sweep.
[[nodiscard]] int columnsOf(const LidarModel& model);

/// How long a sweep takes.
[[nodiscard]] Duration sweepTime(const LidarModel& model);

/// Whether this build has the library that casts rays.
[[nodiscard]] bool canCastRays();

/// What to do where it has not, for messages.
[[nodiscard]] std::string howToCastRays();

/// Which clouds a lidar has that were recorded, and how their points are labelled.
struct RecordedSweepOptions {
  std::string topic;              ///< of the bag
  std::int64_t every = 1;         ///< every n-th cloud is a scene, where no picture says when it is
  Duration time_offset{0};        ///< added to the stamps of the scanner's clock for those of TF
  double tolerance = 0.1;         ///< how far from a surface its points may be measured [m]
  double full_intensity = 255.0;  ///< the recorded number that is an intensity of 1

  /// Largest difference between a scene's stamp and the middle of its cloud's times.
  Duration longest_distance = std::chrono::milliseconds(60);
};

/// The end of the name of a lidar's frame where nothing else says it; the lidar's name is before.
constexpr const char* kOwnFrame = "/lidar_link";

/// A scanner of the run.
struct LidarOptions {
  std::string name;
  std::string group;                  ///< its parameters' full name, for messages
  std::string frame;                  ///< its own; empty: that of its recorded clouds
  std::optional<Pose> X_GS;           ///< where it stands; with `on`, in that object's frame
  std::optional<std::string> on;      ///< the object that it is mounted on
  std::optional<std::string> sensor;  ///< of the world, "model::link::sensor", that it is
  LidarModel model;                   ///< of no sensor; with all changes
  LidarChanges changes;
  std::optional<RecordedSweepOptions> recorded;  ///< it sends no rays of its own then
};

}  // namespace synthetic_dataset::lidar
