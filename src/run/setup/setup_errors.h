#pragma once

#include <string>
#include <vector>

#include "config/motion_list.h"
#include "synthetic_dataset/parameters.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// What is wrong with one of a run's motions.
struct MotionErrors {
  std::string group;  ///< its parameters, for messages
  std::vector<std::string> messages;
};

/// What is wrong with all motions alike is reported once; all else is reported with the motion's
/// group.
[[nodiscard]] std::vector<std::string> mergedErrors(const std::vector<MotionErrors>& motions);

/// The run's settings that no motion reads.
[[nodiscard]] std::vector<std::string> unusedSettings(
    const std::vector<config::MotionEntry>& entries, const std::vector<Parameters>& roots);

/// One error for each parameter that nobody reads, of the run or of a motion's own. Ask when the
/// writers have read theirs.
/// @param roots  the motions' settings; the first one's were given to the writers
[[nodiscard]] std::vector<std::string> unknownParameters(
    const std::vector<config::MotionEntry>& entries, const std::vector<Parameters>& roots);

/// The messages about files that are not there, with what a relative path of the settings starts
/// at, as that is seldom the settings file's folder.
/// @param settings  as the user gave them
[[nodiscard]] std::vector<std::string> explainRelativePaths(std::vector<std::string> messages,
                                                            const Value& settings);

/// The messages about entries that the preset has added and the user did not write say so.
/// @param given  settings without the preset's
/// @param spelled  with what `randomize: {preset: transfer}` stands for
[[nodiscard]] std::vector<std::string> explainPreset(std::vector<std::string> messages,
                                                     const Value& given, const Value& spelled);

}  // namespace synthetic_dataset::run
