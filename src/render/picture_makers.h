#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "base/background_worker.h"
#include "render/pending_picture.h"

namespace synthetic_dataset::render {

/// Makes pictures in the background, two at a time, as parts of making one keep a single core busy.
/// Its threads stay: each new one would take memory that libraries never give back.
class PictureMakers {
 public:
  /// The same picture, made from now on. Waits while its thread has one in work and one that waits.
  /// @param picture  may wait for others that were begun before
  /// @throws Error where the system starts no thread
  [[nodiscard]] PendingPicture begun(PendingPicture picture);

 private:
  std::array<std::optional<base::BackgroundWorker>, 2> workers_;  ///< once they are needed
  std::size_t next_ = 0;
};

}  // namespace synthetic_dataset::render
