#include "render/pending_picture.h"

#include <future>
#include <utility>

namespace synthetic_dataset::render {

PendingPicture begun(PendingPicture picture) {
  // Deferred where no more threads are to be had: what is called has to be there for a second try.
  const auto make = [picture = std::move(picture)]() mutable {
    return std::exchange(picture, {})();  // what it was made of is freed
  };
  return [made = std::async(std::launch::async | std::launch::deferred, make).share()] {
    return made.get();
  };
}

}  // namespace synthetic_dataset::render
