#pragma once

#include <functional>
#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::base {

/// Receives a message about something odd in a text, with its line.
using Remark = std::function<void(const std::string&)>;

/// Reads YAML text with PyYAML's rules (YAML 1.1): 010 is 8, yes is true, "007" is a text, `<<`
/// merges, the last of equal names counts. Tags that are not YAML's own are ignored.
/// @param origin  for messages, usually the file's name
/// @throws Error "<origin>: line 3: ..." if it is not YAML, nests too deep, or grows too large
///     through its aliases
[[nodiscard]] Value parseYaml(const std::string& text, const std::string& origin);

/// Reads a file with parseYaml().
/// @throws Error also if the file cannot be read
[[nodiscard]] Value loadYamlFile(const std::string& file);

/// Reads YAML text as roslaunch's `<rosparam>` does: like parseYaml, and deg(180), rad(pi/2),
/// !degrees and !radians are angles [rad]. What the parameter server cannot hold, and roslaunch
/// fails on, is an error: null, dates, binary data, sets, names that are not text, unknown tags, a
/// second document.
/// @param remark  called if a name is given twice in one group, so that the first is lost
[[nodiscard]] Value parseSettings(const std::string& text, const std::string& origin,
                                  const Remark& remark = {});

}  // namespace synthetic_dataset::base
