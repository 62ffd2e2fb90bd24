#pragma once

#include <memory>

#include "render/pending_picture.h"
#include "render/picture_makers.h"
#include "render/sensor/linear_accumulator.h"

namespace synthetic_dataset::scene {

/// What falls on a sensor while its shutter is open. Two pictures are finished while the next is
/// drawn, as parts of finishing one keep a single core busy.
class Exposure {
 public:
  /// @param makers  have to outlive this
  explicit Exposure(render::PictureMakers& makers) : makers_(&makers) {}

  /// Finishes a picture in the background, and adds it after the one before. Waits for the one
  /// before that.
  /// @param weight  all of an exposure should add up to 1
  void add(render::PendingPicture picture, double weight);

  /// The mean of all, to be made in any thread; what is added from now on is another exposure.
  [[nodiscard]] render::PendingPicture develop();

 private:
  std::shared_ptr<render::LinearAccumulator> light_ = std::make_shared<render::LinearAccumulator>();
  render::PictureMakers* makers_;

  // Called, they wait until a picture has been added; they return none.
  render::PendingPicture before_last_;
  render::PendingPicture last_;
};

}  // namespace synthetic_dataset::scene
