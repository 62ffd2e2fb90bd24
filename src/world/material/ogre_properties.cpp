#include "world/material/ogre_properties.h"

#include <cmath>
#include <locale>
#include <sstream>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {
namespace {

/// Parses a number as OGRE does: "0.5", ".5", "1." and "0.5f".
std::optional<float> parseNumber(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  float value = 0.0F;
  if (!(stream >> value) || !std::isfinite(value)) return std::nullopt;
  std::string rest;
  stream >> rest;
  if (!rest.empty() && rest != "f" && rest != "," && rest != ";") return std::nullopt;
  return value;
}

}  // namespace

const OgreProperty* propertyOf(const OgreObject& object, const std::string& name) {
  const OgreProperty* found = nullptr;
  for (const OgreProperty& property : object.properties) {
    if (property.name == name) found = &property;
  }
  return found;
}

std::string wordOf(const OgreObject& object, const std::string& name, std::size_t index) {
  const OgreProperty* const property = propertyOf(object, name);
  return property != nullptr && property->values.size() > index ? property->values[index] : "";
}

std::vector<const OgreObject*> sectionsOf(const OgreObject& object, const std::string& kind) {
  std::vector<const OgreObject*> sections;
  for (const OgreObject& inner : object.objects) {
    if (inner.kind == kind) sections.push_back(&inner);
  }
  return sections;
}

std::vector<float> numbersOf(const OgreProperty& property, std::size_t first, std::size_t least) {
  std::vector<float> numbers;
  std::string all;
  for (std::size_t i = 0; i < property.values.size(); ++i) {
    all += (i == 0 ? "" : " ") + property.values[i];
    if (i < first || numbers.size() != i - first) continue;
    if (const auto number = parseNumber(property.values[i])) numbers.push_back(*number);
  }
  const bool whole = numbers.size() + first >= property.values.size();
  if (whole && numbers.size() >= least) return numbers;
  throw Error("line " + std::to_string(property.line) + ": " + property.name + ": found '" + all +
              "'; it should have " + std::to_string(least) + " numbers or more");
}

}  // namespace synthetic_dataset::world
