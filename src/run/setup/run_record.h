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

/// The settings that determine a dataset's content, for its manifest: as given, but without those
/// that only say where and how files are written, and without blocks that this run does not use.
/// @param unused  full names of parameters and groups that nobody read
/// @param defaults  the defaults used, by full name
[[nodiscard]] std::map<std::string, output::RunDescription::Setting> usedSettings(
    const Value& parameters, const config::Config& config, const std::vector<std::string>& unused,
    const std::map<std::string, Value>& defaults);

/// The folder to which a writer writes once its dataset has moved to another folder.
[[nodiscard]] std::string movedFolder(const std::string& folder, const std::string& from,
                                      const std::string& to);

/// Reconstructs the settings of a run from its manifest.
/// @param from, to  the dataset's folder, and the output folder for these settings
[[nodiscard]] Value recordedSettings(const output::ManifestContent& content,
                                     const std::string& from, const std::string& to);

/// Names and versions of the software that affects a dataset's bytes, except OpenGL's, which is
/// known only to the renderer.
[[nodiscard]] std::map<std::string, std::string> softwareVersions();

/// The files that settings name, except those of the world and its models: recordings,
/// calibrations, maps, and pictures for surfaces and backgrounds.
[[nodiscard]] std::set<std::string> inputsNamedBy(const config::Config& config);

/// Size and digest of a file from which a dataset is made.
/// @throws Error naming a file that cannot be read
[[nodiscard]] output::RunDescription::Input describeInput(const std::string& file);

/// All files from which the scenes of these motions are made.
[[nodiscard]] std::set<std::string> inputsOf(const std::vector<MotionSetup>& motions);

/// Credits by the path of an input.
using Credits = std::map<std::string, output::RunDescription::Credit>;

/// Who made these files, as far as files say so.
[[nodiscard]] Credits describeCredits(const std::set<std::string>& files);

/// Who made the inputs of these motions; empty if one cannot be read, which is reported by the code
/// that needs it.
[[nodiscard]] Credits creditsOf(const std::vector<MotionSetup>& motions);

}  // namespace synthetic_dataset::run
