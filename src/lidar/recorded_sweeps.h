#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "lidar/lidar_options.h"
#include "motion/recorded/recorded_clouds.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::lidar {

/// The clouds that a lidar has recorded: which of them belongs to a scene, and when its points were
/// measured.
///
/// A scene's cloud is the one with the same stamp, or else the one whose middle of times is
/// nearest: drivers stamp clouds with the time at which a sweep begins, or ends.
class RecordedSweeps {
 public:
  /// @param lidar  with `recorded`
  /// @param bag_files  bags that can be read
  /// @param diagnostics  receives what the user should know: clouds with the stamp of another one
  /// @throws Error naming the setting, if the topic cannot be read, or the clouds are in several
  ///     frames
  RecordedSweeps(const LidarOptions& lidar, const std::vector<std::string>& bag_files,
                 base::Diagnostics& diagnostics);

  [[nodiscard]] const RecordedSweepOptions& options() const { return options_; }

  /// The scanner's frame according to the messages' headers.
  [[nodiscard]] const std::string& frame() const { return clouds_.heads().front().frame; }

  /// The times of scenes, if the clouds determine them: the stamps of every n-th cloud, in TF's
  /// clock. At least one.
  [[nodiscard]] std::vector<Stamp> stamps() const;

  /// How far the middle of the nearest cloud is from a scene; 0 for a cloud's own stamp.
  [[nodiscard]] Duration distanceTo(Stamp scene) const;

  /// When the points of a scene's cloud were measured, relative to the scene's stamp.
  [[nodiscard]] motion::TimeRange timesAround(Stamp scene) const;

  /// What prevents scenes at these times, naming the first cloud that cannot be read: "the cloud of
  /// '/points' at 12 s has no field z, ..."
  [[nodiscard]] std::optional<std::string> problem(const std::vector<Stamp>& scenes) const;

  /// What was measured in a scene's cloud, with times relative to the scene's stamp. May be called
  /// in any thread.
  /// @throws Error naming the setting, the topic and the stamp, if it cannot be read
  [[nodiscard]] motion::MeasuredCloud read(Stamp scene) const;

 private:
  /// The nearest cloud, however far it is from the scene.
  [[nodiscard]] std::size_t cloudOf(Stamp scene) const;
  [[nodiscard]] Stamp stampOf(std::size_t cloud) const;
  [[nodiscard]] std::string nameOf(std::size_t cloud) const;

  std::string setting_;
  RecordedSweepOptions options_;
  motion::RecordedClouds clouds_;
  std::vector<Stamp> middles_;  ///< of the clouds' times, in TF's clock; not always ascending
};

}  // namespace synthetic_dataset::lidar
