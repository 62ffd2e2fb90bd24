#include "world/sdf/sdf_lidars.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "synthetic_dataset/errors.h"
#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {
namespace {

bool isLidar(const std::string& type) {
  return type == "ray" || type == "gpu_ray" || type == "lidar" || type == "gpu_lidar";
}

/// Reads the `<ray>` of a sensor, which SDF has called `<lidar>` since 1.6.
class RayReader {
 public:
  RayReader(const Element& ray, const SourceLocation& location, SdfReading& reading)
      : ray_(ray), location_(location), reading_(reading) {}

  /// `samples` times `resolution` rays. A single one goes straight ahead, whatever the angles are,
  /// as in Gazebo's MultiRayShape.
  /// @param usual  default number of samples
  [[nodiscard]] RayScan scan(const char* direction, double usual) const {
    const Element from = ray_.child("scan").child(direction);
    RayScan scan;
    const double count =
        std::round(number(from, "samples", usual) * number(from, "resolution", 1.0));
    constexpr double kMost = 1e6;
    if (!(count >= 1.0 && count <= kMost)) {
      throw Error(std::string(direction) + ": found " + shortText(count) +
                  " rays; there should be 1 to 1000000");
    }
    scan.count = static_cast<int>(count);
    if (scan.count == 1) return scan;
    scan.first = number(from, "min_angle", 0.0);
    scan.last = number(from, "max_angle", 0.0);
    return scan;
  }

  void readRange(LidarSensor& lidar) const {
    const Element range = ray_.child("range");
    lidar.min_range = number(range, "min", 0.0);
    const bool is_endless = readText(range, "max").find("inf") != std::string::npos;
    lidar.max_range = is_endless || !range.child("max") ? std::numeric_limits<double>::infinity()
                                                        : number(range, "max", 0.0);
    lidar.resolution = number(range, "resolution", 0.0);
    lidar.noise = number(ray_.child("noise"), "stddev", 0.0);
    if (number(ray_.child("noise"), "mean", 0.0) != 0.0) {
      reading_.findings.addNote(location_, "the mean of its noise is left out");
    }
    if (!(lidar.min_range >= 0.0 && lidar.min_range < lidar.max_range && lidar.resolution >= 0.0 &&
          lidar.noise >= 0.0)) {
      throw Error("range: found " + shortText(lidar.min_range) + " to " +
                  shortText(lidar.max_range) + " m in steps of " + shortText(lidar.resolution) +
                  " m with a noise of " + shortText(lidar.noise) +
                  " m; none should be negative, and the first less than the second");
    }
  }

 private:
  [[nodiscard]] double number(const Element& parent, const char* name, double fallback) const {
    return readNumber(parent, name, fallback, location_, reading_);
  }

  const Element& ray_;
  const SourceLocation& location_;
  SdfReading& reading_;
};

}  // namespace

std::optional<LidarSensor> readLidar(const Element& sensor, const std::string& name,
                                     const Pose& X_WL, const Pose& X_LS,
                                     const SourceLocation& location, SdfReading& reading) {
  if (!isLidar(readText(sensor, "type"))) return std::nullopt;
  const Element ray = sensor.child(sensor.child("ray") ? "ray" : "lidar");
  if (!ray) return std::nullopt;
  try {
    const RayReader reader(ray, location, reading);
    LidarSensor lidar;
    lidar.name = name;
    lidar.X_LS = X_LS * readPose(ray, location, reading).pose;
    lidar.X_WS = X_WL * lidar.X_LS;
    lidar.azimuth = reader.scan("horizontal", 640.0);
    lidar.elevation = reader.scan("vertical", 1.0);
    reader.readRange(lidar);
    // The noise set in plugins of gazebo_ros and Velodyne, whose robots leave <noise> at 0.
    for (const Element& plugin : sensor.children("plugin")) {
      if (lidar.noise > 0.0) break;
      lidar.noise = std::max(0.0, readNumber(plugin, "gaussianNoise", 0.0, location, reading));
    }
    lidar.update_rate = readNumber(sensor, "update_rate", 0.0, location, reading);
    return lidar;
  } catch (const Error& error) {
    reading.findings.addNote(location, std::string(error.what()) + "; the lidar is left out");
    return std::nullopt;
  }
}

}  // namespace synthetic_dataset::world
