#pragma once

#include <memory>
#include <string>
#include <vector>

#include "motion/frame_source.h"

namespace synthetic_dataset::motion {
struct BagMotionOptions;
}

namespace synthetic_dataset::run {

/// Keeps recordings for later runs that read the same from them.
class RecordingCache {
 public:
  RecordingCache();
  ~RecordingCache();
  RecordingCache(const RecordingCache&) = delete;
  RecordingCache& operator=(const RecordingCache&) = delete;

  /// Returns a recording, from the cache if it is unchanged.
  /// @throws ErrorList as BagMotion
  [[nodiscard]] std::shared_ptr<const motion::FrameSource> get(
      const motion::BagMotionOptions& options);

 private:
  struct Kept;

  [[nodiscard]] static bool isOf(const Kept& kept, const std::string& wanted,
                                 const motion::BagMotionOptions& options);

  std::vector<Kept> kept_;  ///< most recently used last
};

}  // namespace synthetic_dataset::run
