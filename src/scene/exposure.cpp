#include "scene/exposure.h"

#include <utility>

namespace synthetic_dataset::scene {

void Exposure::add(render::PendingPicture picture, double weight) {
  if (adding_.valid()) adding_.get();
  // Deferred where no more threads are to be had: what is called has to be there for a second try.
  const auto finish = [light = light_, picture = std::move(picture), weight] {
    light->add(picture(), weight);
  };
  adding_ = std::async(std::launch::async | std::launch::deferred, finish);
}

render::PendingPicture Exposure::develop() {
  return [light = std::exchange(light_, std::make_shared<render::LinearAccumulator>()),
          adding = std::exchange(adding_, {})] {
    adding.get();
    return light->result();
  };
}

}  // namespace synthetic_dataset::scene
