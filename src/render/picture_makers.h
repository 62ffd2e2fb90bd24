#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "base/background_worker.h"
#include "render/pending_picture.h"

namespace synthetic_dataset::render {

/// Makes pictures in the background, two at a time, because parts of making one use a single core
/// only. The threads are kept: each new one would take memory that libraries never free.
class PictureMakers {
 public:
  /// Starts making the picture in the background and returns a handle that waits for it. Blocks
  /// while the thread that will make it is busy and already has another picture queued.
  /// @param picture  may wait for others that were begun before it
  /// @throws Error if the system cannot start a thread
  [[nodiscard]] PendingPicture begun(PendingPicture picture);

 private:
  std::array<std::optional<base::BackgroundWorker>, 2> workers_;  ///< once they are needed
  std::size_t next_ = 0;
};

}  // namespace synthetic_dataset::render
