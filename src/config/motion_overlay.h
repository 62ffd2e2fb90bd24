#pragma once

#include <set>
#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::config {

/// The settings that an entry of `motions` may have besides those about the entry itself.
[[nodiscard]] const std::set<std::string>& settingsOfMotions();

/// The settings of an object that an entry of `motions` may have.
[[nodiscard]] const std::set<std::string>& settingsOfMovedObjects();

/// Overlays the run's settings with those of an entry of `motions`. Groups are merged, all else is
/// replaced; and where settings exclude each other, such as a camera's `pose` and `sample`, the
/// entry's own setting replaces the run's.
/// @param objects  whose groups may be among the settings
void overlayMotion(Value::Map& settings, const Value::Map& own,
                   const std::set<std::string>& objects);

}  // namespace synthetic_dataset::config
