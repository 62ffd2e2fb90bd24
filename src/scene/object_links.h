#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "render/draw_list.h"
#include "world/world.h"

namespace synthetic_dataset {

/// LinkInstance::object of what is no object.
inline constexpr int kNoObject = -1;

/// Which links are those of an object, or of kNoObject.
[[nodiscard]] inline render::LinkSelection linksOf(int object,
                                                   const std::vector<world::LinkInstance>& links) {
  render::LinkSelection selection;
  for (const world::LinkInstance& link : links) selection.push_back(link.object == object);
  return selection;
}

/// Those of them that are there.
[[nodiscard]] inline render::LinkSelection presentOf(render::LinkSelection links,
                                                     const world::World& world) {
  const std::vector<bool>& present = world.presentLinks();
  std::transform(links.begin(), links.end(), present.begin(), links.begin(), std::logical_and<>());
  return links;
}

}  // namespace synthetic_dataset
