#pragma once

#include <memory>

#include "render/pending_picture.h"
#include "render/picture_makers.h"
#include "render/sensor/linear_accumulator.h"

namespace synthetic_dataset::scene {

/// The light that falls on a sensor while its shutter is open. Two pictures are finished while the
/// next one is drawn, because parts of finishing a picture use only a single core.
class Exposure {
 public:
  /// @param makers  have to outlive this
  explicit Exposure(render::PictureMakers& makers) : makers_(&makers) {}

  /// Finishes a picture in the background, and adds it after the previous one. Waits for the one
  /// before the previous.
  /// @param weight  the weights of an exposure should add up to 1
  void add(render::PendingPicture picture, double weight);

  /// The weighted mean of all pictures; may be evaluated in any thread. Pictures added from now on
  /// belong to the next exposure.
  [[nodiscard]] render::PendingPicture develop();

 private:
  std::shared_ptr<render::LinearAccumulator> light_ = std::make_shared<render::LinearAccumulator>();
  render::PictureMakers* makers_;

  // Calling these waits until a picture has been added; they return an empty image.
  render::PendingPicture before_last_;
  render::PendingPicture last_;
};

}  // namespace synthetic_dataset::scene
