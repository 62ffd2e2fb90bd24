#pragma once

#include <set>
#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::config {

/// The settings that an entry of `motions` may have beside those that are about the entry itself.
[[nodiscard]] const std::set<std::string>& settingsOfMotions();

/// The settings of an object that an entry of `motions` may have.
[[nodiscard]] const std::set<std::string>& settingsOfMovedObjects();

/// Puts the settings of an entry of `motions` over those of the run. Groups are merged, all else is
/// replaced; and of settings that exclude each other, as `pose` and `sample` of a camera do, an
/// entry's own one takes the place of the run's.
/// @param objects  whose groups may be among the settings
void overlayMotion(Value::Map& settings, const Value::Map& own,
                   const std::set<std::string>& objects);

}  // namespace synthetic_dataset::config
