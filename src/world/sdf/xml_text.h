#pragma once

#include <string>

#include <tinyxml2.h>

namespace synthetic_dataset::world {

/// An element's own text, or an empty one where there is none, or no element.
[[nodiscard]] inline std::string textOf(const tinyxml2::XMLElement* element) {
  const char* text = element != nullptr ? element->GetText() : nullptr;
  return text != nullptr ? text : "";
}

}  // namespace synthetic_dataset::world
