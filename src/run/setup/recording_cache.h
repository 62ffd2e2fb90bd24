#pragma once

#include <memory>
#include <string>
#include <vector>

#include "motion/frame_source.h"

namespace synthetic_dataset::motion {
struct BagMotionOptions;
}

namespace synthetic_dataset::run {

/// Recordings that were read, for the next run that reads the same of them.
class RecordingCache {
 public:
  RecordingCache();
  ~RecordingCache();
  RecordingCache(const RecordingCache&) = delete;
  RecordingCache& operator=(const RecordingCache&) = delete;

  /// A recording, read or kept.
  /// @throws ErrorList as BagMotion
  [[nodiscard]] std::shared_ptr<const motion::FrameSource> get(
      const motion::BagMotionOptions& options);

 private:
  struct Kept;

  [[nodiscard]] static bool isOf(const Kept& kept, const std::string& wanted,
                                 const motion::BagMotionOptions& options);

  std::vector<Kept> kept_;  ///< the one that was asked for last at the end
};

}  // namespace synthetic_dataset::run
