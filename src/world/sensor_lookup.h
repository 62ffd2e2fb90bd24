#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "synthetic_dataset/errors.h"
#include "world/world.h"

namespace synthetic_dataset::world {

/// The last part of a scoped name.
[[nodiscard]] std::string lastOf(const std::string& name);

/// Finds the only sensor of the named model whose last name part matches; null if there is none, or
/// more than one. The parts in between may differ: Gazebo names a sensor on a link that a fixed
/// joint holds after the link that carries it, and gazebo_ros names a camera of a multicamera
/// without its sensor.
template <class Sensor>
const Sensor* findAlike(const std::string& name, const std::vector<Sensor>& sensors) {
  const Sensor* alike = nullptr;
  for (const Sensor& sensor : sensors) {
    const bool is_alike =
        sensor.model() == name.substr(0, name.find("::")) && lastOf(sensor.name) == lastOf(name);
    if (is_alike && alike != nullptr) return nullptr;
    if (is_alike) alike = &sensor;
  }
  return alike;
}

/// Finds the sensor of this name, or the one that findAlike takes for it.
/// @param parameter  the parameter that names it
/// @param kind  kind of sensor, for messages: "camera"
/// @param diagnostics  receives a note if findAlike's sensor is taken
/// @throws Error if there is none
template <class Sensor>
const Sensor& findSensor(const std::string& name, const std::vector<Sensor>& sensors,
                         const std::string& parameter, const std::string& kind,
                         base::Diagnostics& diagnostics) {
  for (const Sensor& sensor : sensors) {
    if (sensor.name == name) return sensor;
  }
  if (const Sensor* alike = findAlike(name, sensors)) {
    diagnostics.note(parameter, "'" + name + "' is taken for '" + alike->name + "'");
    return *alike;
  }
  std::string there;
  for (const Sensor& sensor : sensors) there += (there.empty() ? "" : ", ") + sensor.name;
  throw Error(parameter + ": neither the world nor an object has a " + kind + " '" + name +
              "' (model::link::sensor); there " + (there.empty() ? "is none" : "are " + there));
}

/// @param kind  kind of sensor: "camera"
/// @throws Error for a sensor on a link of an object that comes in several variants
void requireFixedVariant(const std::string& name, const std::string& kind,
                         const LinkInstance& carrier, const std::vector<LinkInstance>& links);

/// The index of the link that carries a sensor, if that link is not static.
/// @throws Error as requireFixedVariant
template <class Sensor>
std::optional<std::size_t> movingLinkOf(const Sensor& sensor, const std::string& kind,
                                        const std::vector<LinkInstance>& links) {
  const auto carries = [&](const LinkInstance& link) {
    return link.role != Role::kStatic && link.model == sensor.model() &&
           link.link->name == sensor.link;
  };
  const auto found = std::find_if(links.begin(), links.end(), carries);
  if (found == links.end()) return std::nullopt;
  requireFixedVariant(sensor.name, kind, *found, links);
  return static_cast<std::size_t>(found - links.begin());
}

}  // namespace synthetic_dataset::world
