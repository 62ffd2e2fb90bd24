#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "config/config.h"
#include "output/manifest/manifest_content.h"
#include "output/manifest/run_description.h"
#include "run/setup/motion_setup.h"
#include "synthetic_dataset/label_writer.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// The settings that decide what a dataset holds, for its manifest: as given, without those that
/// only say where and how files are written, and without blocks that this run does not use.
/// @param unused  full names of parameters and groups that nobody read
/// @param defaults  the defaults taken, by full name
[[nodiscard]] std::map<std::string, output::RunDescription::Setting> usedSettings(
    const Value& parameters, const config::Config& config, const std::vector<std::string>& unused,
    const std::map<std::string, Value>& defaults);

/// Where a writer writes once its dataset lies in another folder.
[[nodiscard]] std::string movedFolder(const std::string& folder, const std::string& from,
                                      const std::string& to);

/// The settings again of a run that left a manifest.
/// @param from, to  where its dataset lies, and where one of these settings is to lie
[[nodiscard]] Value recordedSettings(const output::ManifestContent& content,
                                     const std::string& from, const std::string& to);

/// Names and versions of what shapes a dataset's bytes, but for OpenGL's: who draws knows it.
[[nodiscard]] std::map<std::string, std::string> softwareVersions();

/// The files that settings name, but for the world's and its models': recordings, calibrations,
/// maps, and the pictures that surfaces may have or that lie behind the world.
[[nodiscard]] std::set<std::string> inputsNamedBy(const config::Config& config);

/// Size and digest of a file that a dataset is made from.
/// @throws Error naming a file that cannot be read
[[nodiscard]] output::RunDescription::Input describeInput(const std::string& file);

/// All files that the scenes of these motions are made of.
[[nodiscard]] std::set<std::string> inputsOf(const std::vector<MotionSetup>& motions);

/// By the path of an input.
using Credits = std::map<std::string, output::RunDescription::Credit>;

/// Who made these files, where a file says so.
[[nodiscard]] Credits describeCredits(const std::set<std::string>& files);

/// Who made the inputs of these motions; nobody where one cannot be read, which is reported by who
/// needs it.
[[nodiscard]] Credits creditsOf(const std::vector<MotionSetup>& motions);

}  // namespace synthetic_dataset::run
