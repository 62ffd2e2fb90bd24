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
  std::string group;                   ///< "motions/0", for messages; empty: the run's only one
  std::string name;                    ///< its setting `name`, else its index in the list
  double weight = 1.0;                 ///< > 0: its share of the scenes, beside the others'
  std::optional<std::string> split;    ///< in which all of its scenes are; nothing: as drawn
  std::set<std::string> objects = {};  ///< of robot_list, that take part in it; empty: all
  Value::Map own = {};                 ///< what it says itself
  Value settings;                      ///< all that holds for it: its own settings over the run's

  /// Whether it says this itself: "camera/info_file".
  [[nodiscard]] bool says(const std::string& full_name) const;
};

/// Where a run's scenes come from, in the order in which they are numbered.
struct MotionList {
  std::vector<MotionEntry> entries;         ///< at least one
  bool is_weighted = false;                 ///< else each entry gives all that it has
  std::optional<std::int64_t> scenes = {};  ///< of all entries together; else as many as fit
  std::vector<std::string> errors = {};
};

/// Reads the list `motions`; without it the run's settings are those of its only motion. What is
/// wrong is among the errors, with a harmless value in its place.
/// @param parameters  all settings of the run
[[nodiscard]] MotionList readMotions(const Value& parameters);

}  // namespace synthetic_dataset::config
