#include "render/recent_views.h"

#include <algorithm>
#include <cstddef>

namespace synthetic_dataset::render {

bool RecentViews::comesBack(const View& view) {
  constexpr std::size_t kRemembered = 64;
  constexpr std::ptrdiff_t kOften = 2;
  const Seen here{clipFromCamera(view.camera), view.X_WC.matrix()};
  const auto times = std::count_if(recent_.begin(), recent_.end(), [&](const Seen& seen) {
    return seen.clip_from_camera == here.clip_from_camera && seen.X_WC == here.X_WC;
  });
  recent_.push_back(here);
  if (recent_.size() > kRemembered) recent_.pop_front();
  return times >= kOften;
}

std::size_t RecentViews::maxKept(std::size_t bytes) {
  constexpr std::size_t kMemory = 512U << 20U;  // [byte] in total
  constexpr std::size_t kMost = 8;
  return std::clamp(kMemory / bytes, std::size_t{1}, kMost);
}

}  // namespace synthetic_dataset::render
