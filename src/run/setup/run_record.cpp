#include "run/setup/run_record.h"

#include <algorithm>
#include <utility>

#include "base/image/deflate.h"
#include "base/json_text.h"
#include "config/settings_text.h"
#include "motion/bag/ros2_bag.h"
#include "output/files/digest.h"
#include "output/files/file_name_rules.h"
#include "randomize/appearance/picture_folder.h"
#include "randomize/appearance/picture_options.h"
#include "randomize/placement/map_file.h"
#include "run/setup/credit.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::run {
namespace {

/// Whether a setting, or a group that contains it, is among `names`.
bool isIn(const std::set<std::string>& names, const std::string& setting) {
  for (std::size_t end = 0; end != std::string::npos;) {
    end = setting.find('/', end + 1);
    if (names.count(setting.substr(0, end)) != 0) return true;
  }
  return false;
}

/// The pictures that randomization may draw.
std::set<std::string> picturesOf(const randomize::Randomization& randomization) {
  std::vector<std::string> sources;
  for (const auto& [name, material] : randomization.materials) {
    if (material.textures) sources.push_back(*material.textures);
  }
  if (randomization.distractors) sources.push_back(randomization.distractors->textures);
  std::set<std::string> pictures;
  const auto add = [&](const std::string& folder, randomize::PictureKind kind) {
    for (const std::string& file : randomize::picturesIn(folder, kind)) pictures.insert(file);
  };
  for (const std::string& source : sources) {
    if (source == "procedural" || source == "none" || source == randomize::kNatural) continue;
    add(source, randomize::PictureKind::kEncoded);
  }
  const auto& background = randomization.background.pictures;
  if (background && background->folder != randomize::kNatural) {
    add(background->folder, randomize::PictureKind::kAny);
  }
  return pictures;
}

/// The main files from which scenes are made; files included by these are described with them.
std::set<std::string> sourcesOf(const std::vector<MotionSetup>& motions) {
  std::set<std::string> files;
  for (const MotionSetup& motion : motions) {
    const std::set<std::string> named = inputsNamedBy(motion.config);
    files.insert(named.begin(), named.end());
    files.insert(motion.inputs.begin(), motion.inputs.end());
  }
  return files;
}

}  // namespace

std::map<std::string, output::RunDescription::Setting> usedSettings(
    const Value& parameters, const config::Config& config, const std::vector<std::string>& unused,
    const std::map<std::string, Value>& defaults) {
  // None of these changes the content of the dataset.
  std::set<std::string> left_out = {"output_folder", "if_exists",   "sync",           "shard",
                                    "processes",     "only_scenes", "rendering/reuse"};
  left_out.insert(unused.begin(), unused.end());
  for (const output::WriterOptions& writer : config.writers) {
    left_out.insert(writer.name + "/output_folder");
  }
  std::map<std::string, output::RunDescription::Setting> settings;
  for (const auto& [name, text] : config::flatSettings(parameters)) {
    if (!isIn(left_out, name)) settings[name] = {text, false};
  }
  for (const auto& [name, value] : defaults) {
    if (!isIn(left_out, name)) settings.insert({name, {base::jsonText(value), true}});
  }
  // The frames of recorded clouds, which verify and merge would not know otherwise.
  for (const lidar::LidarOptions& lidar : config.lidars) {
    if (!lidar.recorded) continue;
    settings.insert(
        {"lidars/" + lidar.name + "/frame_id", {base::jsonText(Value(lidar.frame)), true}});
  }
  return settings;
}

std::string movedFolder(const std::string& folder, const std::string& from, const std::string& to) {
  if (!output::liesWithin(folder, from)) return folder;
  return to + folder.substr(from.size());
}

Value recordedSettings(const output::ManifestContent& content, const std::string& from,
                       const std::string& to) {
  std::map<std::string, std::string> given = output::givenSettings(content.run);
  given["output_folder"] = base::jsonText(Value(to));
  for (const output::StoreWriter& writer : content.writers) {
    given[writer.name + "/output_folder"] =
        base::jsonText(Value(movedFolder(writer.output_folder, from, to)));
  }
  return config::settingsTree(given);
}

std::map<std::string, std::string> softwareVersions() {
  std::map<std::string, std::string> versions = base::deflateLibraries();
  versions.insert({{"synthetic_dataset", SYNTHETIC_DATASET_VERSION},
                   {"assimp", ASSIMP_VERSION},
                   {"bullet", BULLET_VERSION},
                   {"opencv", OPENCV_VERSION}});
  return versions;
}

std::set<std::string> inputsNamedBy(const config::Config& config) {
  std::set<std::string> inputs;
  for (const std::string& bag : config.motion.bag_files) {
    for (std::string& file : motion::filesOfBag(bag)) inputs.insert(std::move(file));
  }
  for (const scene::CameraOptions& camera : config.cameras) {
    if (camera.info_file) inputs.insert(*camera.info_file);
  }
  if (config.placement.map_file) {
    inputs.insert(*config.placement.map_file);
    inputs.insert(randomize::readMapYaml(*config.placement.map_file).image);
  }
  inputs.merge(picturesOf(config.randomization));
  return inputs;
}

output::RunDescription::Input describeInput(const std::string& file) {
  const output::FileDigest found = output::digestOfInput(file);
  return {found.bytes, found.digest};
}

std::set<std::string> inputsOf(const std::vector<MotionSetup>& motions) {
  std::set<std::string> files = sourcesOf(motions);
  for (const MotionSetup& motion : motions) {
    files.insert(motion.included.begin(), motion.included.end());
  }
  return files;
}

Credits describeCredits(const std::set<std::string>& files) {
  CreditFinder finder;
  Credits credits;
  for (const std::string& path : files) {
    const Credit found = finder.creditOf(path);
    if (found.author.empty() && found.license.empty()) continue;
    credits[path] = {found.author, found.author_in.string(), found.license,
                     found.license_in.string()};
  }
  return credits;
}

Credits creditsOf(const std::vector<MotionSetup>& motions) {
  try {
    return describeCredits(sourcesOf(motions));
  } catch (const Error&) {
    return {};
  }
}

}  // namespace synthetic_dataset::run
