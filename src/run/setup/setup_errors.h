#pragma once

#include <string>
#include <vector>

#include "config/motion_list.h"
#include "synthetic_dataset/parameters.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// Errors of one of a run's motions.
struct MotionErrors {
  std::string group;  ///< its parameter group, for messages
  std::vector<std::string> messages;
};

/// Merges messages: an error shared by all motions is reported once, any other with its motion's
/// group.
[[nodiscard]] std::vector<std::string> mergedErrors(const std::vector<MotionErrors>& motions);

/// The run's settings that no motion reads.
[[nodiscard]] std::vector<std::string> unusedSettings(
    const std::vector<config::MotionEntry>& entries, const std::vector<Parameters>& roots);

/// One error for each parameter of the run or of a motion that nobody reads. Call after the writers
/// have read theirs.
/// @param roots  the motions' settings; the writers were given the first motion's
[[nodiscard]] std::vector<std::string> unknownParameters(
    const std::vector<config::MotionEntry>& entries, const std::vector<Parameters>& roots);

/// Adds to messages about missing files where relative paths in the settings start, as that is
/// seldom the settings file's folder.
/// @param settings  as the user gave them
[[nodiscard]] std::vector<std::string> explainRelativePaths(std::vector<std::string> messages,
                                                            const Value& settings);

/// Adds a note to messages about entries that come from the preset rather than from the user.
/// @param given  settings without those of the preset
/// @param spelled  settings with `randomize: {preset: transfer}` expanded
[[nodiscard]] std::vector<std::string> explainPreset(std::vector<std::string> messages,
                                                     const Value& given, const Value& spelled);

}  // namespace synthetic_dataset::run
