#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::config {

/// One of the motions that a run's scenes come from.
struct MotionEntry {
  std::string group;                   ///< "motions/0", for messages; empty: the run's only motion
  std::string name;                    ///< its setting `name`, else its index in the list
  double weight = 1.0;                 ///< > 0: its share of the scenes, relative to the others'
  std::optional<std::string> split;    ///< of all of its scenes; nullopt: as `split` assigns them
  std::set<std::string> objects = {};  ///< those of robot_list that take part in it; empty: all
  Value::Map own = {};                 ///< its own settings
  Value settings;                      ///< all that apply to it: its own over the run's

  /// Whether its own settings include this one: "camera/info_file".
  [[nodiscard]] bool says(const std::string& full_name) const;
};

/// Where a run's scenes come from, in the order in which they are numbered.
struct MotionList {
  std::vector<MotionEntry> entries;         ///< at least one
  bool is_weighted = false;                 ///< else each entry provides all its scenes
  std::optional<std::int64_t> scenes = {};  ///< of all entries together; nullopt: as many as fit
  std::vector<std::string> errors = {};
};

/// Reads the list `motions`; without it, the run's settings are those of its only motion. What is
/// wrong is listed in the errors, and a harmless value is used instead.
/// @param parameters  all settings of the run
[[nodiscard]] MotionList readMotions(const Value& parameters);

}  // namespace synthetic_dataset::config
