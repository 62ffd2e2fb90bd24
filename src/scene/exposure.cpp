#include "scene/exposure.h"

#include <utility>

namespace synthetic_dataset::scene {

void Exposure::add(render::PendingPicture picture, double weight) {
  if (before_last_) before_last_();
  // Captures are released as soon as they are used, because the next picture holds this one.
  render::PendingPicture added = makers_->begun(
      [light = light_, picture = std::move(picture), weight, before = last_]() mutable {
        const cv::Mat pixels = std::exchange(picture, {})();
        if (before) std::exchange(before, {})();
        light->add(pixels, weight);
        return cv::Mat();
      });
  before_last_ = std::exchange(last_, std::move(added));
}

render::PendingPicture Exposure::develop() {
  before_last_ = {};
  return [light = std::exchange(light_, std::make_shared<render::LinearAccumulator>()),
          last = std::exchange(last_, {})] {
    last();
    return light->result();
  };
}

}  // namespace synthetic_dataset::scene
