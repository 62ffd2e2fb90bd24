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

/// The frames of a dataset in nuScenes' order: samples, the sweeps between them, and the links to
/// the previous and next of each.
namespace synthetic_dataset::nuscenes {

/// An object at an instant, as seen by all cameras and the lidar.
struct Annotation {
  const SeenObject* seen = nullptr;  ///< by the first sensor that sees it
  double visibility = 0.0;           ///< the maximum of all
  std::int64_t pixels = 0;           ///< the sum of all
  std::int64_t points = 0;           ///< of the lidar
  std::string prev;
  std::string next;
};

/// A sensor's data at an instant.
struct SensorData {
  const Frame* frame = nullptr;
  bool is_keyframe = true;
  std::string prev;
  std::string next;
};

/// An annotated instant.
struct Sample {
  const Frame* first = nullptr;                    ///< first frame of the instant
  std::vector<SensorData> data;                    ///< in order of time
  std::map<std::int64_t, Annotation> annotations;  ///< by object
  std::string prev;
  std::string next;

  [[nodiscard]] std::string token() const;
  [[nodiscard]] std::string tokenOf(std::int64_t object) const;
};

/// The samples of a dataset, each linked to the previous and the next. Data between samples belong
/// to the sample that follows or, if there is none, to the last one (the devkit's
/// docs/schema_nuscenes.md). Sequences without a sample are left out.
class Samples {
 public:
  /// @param dataset, frames  must outlive this; frames are in order of time
  Samples(const DatasetInfo& dataset, const std::vector<Frame>& frames,
          const NuScenesOptions& options);

  [[nodiscard]] const std::vector<std::unique_ptr<Sample>>& all() const { return all_; }

 private:
  /// Links the elements of several chains to the previous and the next.
  class Chain {
   public:
    /// @return  the token of the previous element; empty if there is none
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
