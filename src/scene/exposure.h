#pragma once

#include <future>
#include <memory>

#include "render/pending_picture.h"
#include "render/sensor/linear_accumulator.h"

namespace synthetic_dataset::scene {

/// What falls on a sensor while its shutter is open. One picture is finished while the next is
/// drawn.
class Exposure {
 public:
  /// Finishes a picture and adds it, in a thread of its own; waits for the one before.
  /// @param weight  all of an exposure should add up to 1
  void add(render::PendingPicture picture, double weight);

  /// The mean of all, to be made in any thread; what is added from now on is another exposure.
  [[nodiscard]] render::PendingPicture develop();

 private:
  std::shared_ptr<render::LinearAccumulator> light_ = std::make_shared<render::LinearAccumulator>();
  std::shared_future<void> adding_;  ///< the last picture
};

}  // namespace synthetic_dataset::scene
