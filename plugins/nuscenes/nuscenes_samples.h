#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "plugins/nuscenes/nuscenes_frames.h"
#include "plugins/nuscenes/nuscenes_options.h"
#include "synthetic_dataset/label_writer.h"

/// The frames of a dataset in nuScenes' order: samples, what is measured between them, and what is
/// before and after each.
namespace synthetic_dataset::nuscenes {

/// What is known of an object at an instant, by all cameras that see it and the lidar.
struct Annotation {
  const SeenObject* seen = nullptr;  ///< by the first of them
  double visibility = 0.0;           ///< the greatest
  std::int64_t pixels = 0;           ///< of all
  std::int64_t points = 0;           ///< of the lidar
  std::string prev;
  std::string next;
};

/// What a sensor has of an instant.
struct SensorData {
  const Frame* frame = nullptr;
  bool is_keyframe = true;
  std::string prev;
  std::string next;
};

/// An instant that is annotated.
struct Sample {
  const Frame* first = nullptr;                    ///< of the instant
  std::vector<SensorData> data;                    ///< in the order of time
  std::map<std::int64_t, Annotation> annotations;  ///< by object
  std::string prev;
  std::string next;

  [[nodiscard]] std::string token() const;
  [[nodiscard]] std::string tokenOf(std::int64_t object) const;
};

/// The samples of a dataset, each linked with those before and after it. What is measured between
/// samples belongs to the one that follows it, or to the last where none does (the devkit's
/// docs/schema_nuscenes.md). A sequence without a sample has nothing here.
class Samples {
 public:
  /// @param dataset, frames  have to outlive this; frames are in the order of time
  Samples(const DatasetInfo& dataset, const std::vector<Frame>& frames,
          const NuScenesOptions& options);

  [[nodiscard]] const std::vector<std::unique_ptr<Sample>>& all() const { return all_; }

 private:
  /// What is before and after each of several chains' links.
  class Chain {
   public:
    /// @return  the token of the link before; empty for none
    std::string add(std::int64_t first, std::int64_t second, std::string& next,
                    const std::string& token);

   private:
    std::map<std::pair<std::int64_t, std::int64_t>, std::pair<std::string, std::string*>> last_;
  };

  void addKeyframe(const Frame& frame);
  void leaveOutFewPoints(std::int64_t min_points);
  void link(Sample& sample);

  const DatasetInfo& dataset_;
  std::vector<std::unique_ptr<Sample>> all_;
  std::map<std::int64_t, std::vector<SensorData>> waiting_;  ///< for the next sample, by sequence
  std::map<std::int64_t, Sample*> last_;                     ///< by sequence
  Chain samples_;
  Chain data_;
  Chain annotations_;
};

}  // namespace synthetic_dataset::nuscenes
