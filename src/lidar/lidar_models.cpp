#include <map>
#include <utility>

#include "lidar/lidar_options.h"

namespace synthetic_dataset::lidar {
namespace {

constexpr double kPi = 3.14159265358979323846;

double radians(double degrees) { return degrees * kPi / 180.0; }

/// Velodyne's scanners turn clockwise, seen from above; a sweep begins at the back.
LidarModel velodyne(std::vector<double> elevations, double column_period) {
  LidarModel model;
  model.elevations = std::move(elevations);
  model.column_period = column_period;
  model.first_azimuth = kPi;
  model.last_azimuth = -kPi;
  model.resolution = 0.002;
  return model;
}

/// The lower and the upper half of the rings fire alternately, each from its lowest ring up.
std::vector<double> alternatingTimes(std::size_t rings, double laser_period) {
  std::vector<double> times;
  for (std::size_t ring = 0; ring < rings; ++ring) {
    const std::size_t half = rings / 2;
    const std::size_t laser = ring < half ? 2 * ring : 2 * (ring - half) + 1;
    times.push_back(static_cast<double>(laser) * laser_period);
  }
  return times;
}

/// Velodyne, "VLP-16 User Manual", 63-9243 Rev. E: 16 lasers from -15 to 15 degrees, one every
/// 2.304 us, all in 55.296 us; up to 100 m, accuracy +-3 cm, resolution 2 mm.
LidarModel vlp16() {
  LidarModel model = velodyne(evenAngles(16, radians(-15.0), radians(15.0)), 55.296e-6);
  model.firing_times = alternatingTimes(16, 2.304e-6);
  model.min_range = 0.4;
  model.max_range = 100.0;
  model.noise = 0.015;  // +-3 cm, taken as two standard deviations
  return model;
}

/// Velodyne, "HDL-32E User Manual", 63-9113 Rev. M: 32 lasers from -30.67 to 10.67 degrees, one
/// every 1.152 us, all in 46.08 us; up to 100 m, accuracy +-2 cm, resolution 2 mm.
LidarModel hdl32e() {
  LidarModel model = velodyne(evenAngles(32, radians(-92.0 / 3.0), radians(32.0 / 3.0)), 46.08e-6);
  model.firing_times = alternatingTimes(32, 1.152e-6);
  model.min_range = 1.0;
  model.max_range = 100.0;
  model.noise = 0.01;
  return model;
}

/// Velodyne, "HDL-64E S2 and S2.1 User's Manual", 63-HDL64ES2 Rev. D: a block of 32 lasers from
/// -24.33 to -8.83 degrees, half a degree apart, and one from -8.33 to 2 degrees, a third of a
/// degree apart; 0.1728 degrees from column to column at 10 Hz; 50 m at a reflectivity of 10 %, 120
/// m at 80 %; accuracy below 2 cm. Its lasers are assumed to fire together.
LidarModel hdl64e() {
  std::vector<double> elevations = evenAngles(32, radians(-73.0 / 3.0), radians(-53.0 / 6.0));
  for (const double angle : evenAngles(32, radians(-25.0 / 3.0), radians(2.0))) {
    elevations.push_back(angle);
  }
  LidarModel model = velodyne(std::move(elevations), 48e-6);
  model.min_range = 0.9;
  model.max_range = 120.0;
  model.noise = 0.01;
  model.reach_at_tenth = 50.0;
  return model;
}

/// Ouster, "OS1 Mid-Range High-Resolution Imaging Lidar" data sheet, Rev. 06: a field of view of 45
/// degrees, 512, 1024 or 2048 columns at 10 or 20 Hz, all beams at once, numbered from the top; 120
/// m at 80 % reflectivity, 45 m at 10 %; precision 1 to 5 cm, in steps of 1 mm. Clockwise. The
/// beams' azimuth offsets differ from device to device: `beams/azimuth_offsets` takes those of its
/// metadata.
LidarModel os1(int rings) {
  LidarModel model;
  model.elevations = evenAngles(rings, radians(22.5), radians(-22.5));
  model.first_azimuth = kPi;
  model.last_azimuth = -kPi;
  model.min_range = 0.3;
  model.max_range = 120.0;
  model.resolution = 0.001;
  model.noise = 0.015;
  model.reach_at_tenth = 45.0;
  return model;
}

/// Hokuyo, "UTM-30LX Specification", C-42-3615: 270 degrees in steps of a quarter, 25 ms per turn,
/// 0.1 to 30 m, a standard deviation of 1 cm up to 10 m, in steps of 1 mm. Counter-clockwise.
LidarModel utm30lx() {
  LidarModel model;
  model.elevations = {0.0};
  model.rate = 40.0;
  model.columns = 1081;
  model.first_azimuth = radians(-135.0);
  model.last_azimuth = radians(135.0);
  model.min_range = 0.1;
  model.max_range = 30.0;
  model.resolution = 0.001;
  model.noise = 0.01;
  return model;
}

const std::map<std::string, LidarModel>& models() {
  static const std::map<std::string, LidarModel> kModels = {
      {"HDL-32E", hdl32e()}, {"HDL-64E", hdl64e()},   {"OS1-128", os1(128)}, {"OS1-32", os1(32)},
      {"OS1-64", os1(64)},   {"UTM-30LX", utm30lx()}, {"VLP-16", vlp16()}};
  return kModels;
}

}  // namespace

std::vector<double> evenAngles(int count, double first, double last) {
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 0.5;
    angles.push_back(first + share * (last - first));
  }
  return angles;
}

void LidarChanges::apply(LidarModel& model) const {
  model.rate = rate.value_or(model.rate);
  model.min_range = min_range.value_or(model.min_range);
  model.max_range = max_range.value_or(model.max_range);
  model.resolution = resolution.value_or(model.resolution);
  model.noise = noise.value_or(model.noise);
  model.dropout = dropout.value_or(model.dropout);
  if (!reach_at_tenth) return;
  model.reach_at_tenth = *reach_at_tenth > 0.0 ? reach_at_tenth : std::nullopt;
}

std::vector<std::string> modelNames() {
  std::vector<std::string> names;
  for (const auto& [name, model] : models()) names.push_back(name);
  return names;
}

std::optional<LidarModel> modelOf(const std::string& name) {
  const auto found = models().find(name);
  if (found == models().end()) return std::nullopt;
  return found->second;
}

}  // namespace synthetic_dataset::lidar
