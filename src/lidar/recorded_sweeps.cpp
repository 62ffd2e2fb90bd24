#include "lidar/recorded_sweeps.h"

#include <algorithm>

#include "motion/bag/ros_time.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::lidar {

RecordedSweeps::RecordedSweeps(const LidarOptions& lidar, const std::vector<std::string>& bag_files,
                               base::Diagnostics& diagnostics)
    : setting_(lidar.group + "/cloud_topic"),
      options_(*lidar.recorded),
      clouds_(base::namingPlace(
          setting_, [&] { return motion::RecordedClouds(bag_files, lidar.recorded->topic); })) {
  const std::vector<motion::CloudHead>& heads = clouds_.heads();
  for (std::size_t i = 0; i < heads.size(); ++i) {
    if (heads[i].frame != frame()) {
      throw Error(setting_ + ": " + nameOf(i) + " is in the frame '" + heads[i].frame +
                  "', and those before it in '" + frame() + "'; a lidar has one frame");
    }
    middles_.push_back(stampOf(i) + (heads[i].times.first + heads[i].times.last) / 2);
  }
  if (clouds_.repeatedCount() > 0) {
    diagnostics.warning(setting_, "clouds with the same stamp as another are left out",
                        clouds_.repeatedCount());
  }
}

Stamp RecordedSweeps::stampOf(std::size_t cloud) const {
  return clouds_.heads()[cloud].stamp + options_.time_offset;
}

std::string RecordedSweeps::nameOf(std::size_t cloud) const {
  return "the cloud of '" + options_.topic + "' at " +
         motion::secondsText(clouds_.heads()[cloud].stamp);
}

std::vector<Stamp> RecordedSweeps::stamps() const {
  std::vector<Stamp> stamps;
  for (std::size_t i = 0; i < middles_.size(); i += static_cast<std::size_t>(options_.every)) {
    stamps.push_back(stampOf(i));
  }
  return stamps;
}

std::size_t RecordedSweeps::cloudOf(Stamp scene) const {
  const std::vector<motion::CloudHead>& heads = clouds_.heads();
  const Stamp wanted = scene - options_.time_offset;
  const auto own = std::lower_bound(
      heads.begin(), heads.end(), wanted,
      [](const motion::CloudHead& head, Stamp stamp) { return head.stamp < stamp; });
  const auto index = own - heads.begin();
  if (own != heads.end() && own->stamp == wanted) return static_cast<std::size_t>(index);
  // A middle is at most 1 s from its cloud's stamp, see cloud_points.h.
  constexpr Duration kFarthest = std::chrono::seconds(1);
  const Duration far = 2 * kFarthest + options_.longest_distance;
  std::size_t nearest = static_cast<std::size_t>(std::max<std::ptrdiff_t>(index - 1, 0));
  const auto consider = [&](std::size_t cloud) {
    if (std::chrono::abs(middles_[cloud] - scene) < std::chrono::abs(middles_[nearest] - scene)) {
      nearest = cloud;
    }
  };
  for (auto i = static_cast<std::size_t>(index); i < heads.size(); ++i) {
    if (heads[i].stamp - wanted > far) break;
    consider(i);
  }
  for (auto i = static_cast<std::size_t>(index); i-- > 0;) {
    if (wanted - heads[i].stamp > far) break;
    consider(i);
  }
  return nearest;
}

Duration RecordedSweeps::distanceTo(Stamp scene) const {
  const std::size_t cloud = cloudOf(scene);
  if (stampOf(cloud) == scene) return Duration{0};
  return std::chrono::abs(middles_[cloud] - scene);
}

motion::TimeRange RecordedSweeps::timesAround(Stamp scene) const {
  const std::size_t cloud = cloudOf(scene);
  const Duration since = stampOf(cloud) - scene;
  const motion::TimeRange& times = clouds_.heads()[cloud].times;
  return {times.first + since, times.last + since};
}

std::optional<std::string> RecordedSweeps::problem(const std::vector<Stamp>& scenes) const {
  std::string first;
  std::int64_t others = 0;
  for (const Stamp scene : scenes) {
    const std::size_t cloud = cloudOf(scene);
    const motion::CloudHead& head = clouds_.heads()[cloud];
    const std::string& problem = head.problem.empty() ? head.time_problem : head.problem;
    if (problem.empty()) continue;
    if (first.empty()) {
      first = setting_ + ": " + nameOf(cloud) + " " + problem;
    } else {
      ++others;
    }
  }
  if (first.empty()) return std::nullopt;
  return others == 0 ? first
                     : first + "; " + std::to_string(others) + " more scenes have such clouds";
}

motion::MeasuredCloud RecordedSweeps::read(Stamp scene) const {
  const std::size_t cloud = cloudOf(scene);
  try {
    motion::MeasuredCloud measured = clouds_.readMeasured(cloud);
    const Duration since = stampOf(cloud) - scene;
    for (motion::MeasuredPoint& point : measured.points) point.time += since;
    return measured;
  } catch (const Error& error) {
    throw Error(setting_ + ": " + nameOf(cloud) + ": " + error.what());
  }
}

}  // namespace synthetic_dataset::lidar
