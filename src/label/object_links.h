#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "render/view.h"
#include "world/world.h"

namespace synthetic_dataset::label {

/// LinkInstance::object of links that belong to no object.
inline constexpr int kNoObject = -1;

/// Selects the links of an object, or those that belong to no object (kNoObject).
[[nodiscard]] inline render::LinkSelection linksOf(int object,
                                                   const std::vector<world::LinkInstance>& links) {
  render::LinkSelection selection;
  for (const world::LinkInstance& link : links) selection.push_back(link.object == object);
  return selection;
}

/// The indices of the links of an object's variant.
[[nodiscard]] inline std::vector<std::size_t> linksOfVariant(
    std::size_t object, std::size_t variant, const std::vector<world::LinkInstance>& links) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const bool is_of_object = links[i].object == static_cast<int>(object);
    if (is_of_object && links[i].variant == variant) indices.push_back(i);
  }
  return indices;
}

[[nodiscard]] inline std::vector<const world::Link*> linksAt(
    const std::vector<std::size_t>& indices, const std::vector<world::LinkInstance>& links) {
  std::vector<const world::Link*> result;
  for (const std::size_t index : indices) result.push_back(links[index].link);
  return result;
}

/// The selected links that are present.
[[nodiscard]] inline render::LinkSelection presentOf(render::LinkSelection links,
                                                     const render::LinkSelection& present) {
  std::transform(links.begin(), links.end(), present.begin(), links.begin(), std::logical_and<>());
  return links;
}

}  // namespace synthetic_dataset::label
