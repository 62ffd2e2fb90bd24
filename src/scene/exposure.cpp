#include "scene/exposure.h"

#include <utility>

namespace synthetic_dataset::scene {

void Exposure::add(render::PendingPicture picture, double weight) {
  if (before_last_.valid()) before_last_.get();
  // Deferred where no more threads are to be had: what is called has to be there for a second try.
  // What it holds is freed as it is used, as the next one holds it.
  const auto finish = [light = light_, picture = std::move(picture), weight,
                       before = last_]() mutable {
    const cv::Mat pixels = std::exchange(picture, {})();
    if (before.valid()) std::exchange(before, {}).get();
    light->add(pixels, weight);
  };
  before_last_ =
      std::exchange(last_, std::async(std::launch::async | std::launch::deferred, finish));
}

render::PendingPicture Exposure::develop() {
  before_last_ = {};
  return [light = std::exchange(light_, std::make_shared<render::LinearAccumulator>()),
          last = std::exchange(last_, {})] {
    last.get();
    return light->result();
  };
}

}  // namespace synthetic_dataset::scene
