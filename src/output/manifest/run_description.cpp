#include "output/manifest/run_description.h"

#include <filesystem>
#include <set>
#include <utility>

#include "output/files/digest.h"

namespace synthetic_dataset::output {
namespace {

/// Lists entries that exist on one side only, or differ.
/// @param text  describes an entry
template <class Entries, class Text>
void compare(const std::string& what, const Entries& one, const Entries& other,
             const std::string& before, const std::string& now, const Text& text,
             std::vector<std::string>& lines) {
  std::set<std::string> names;
  for (const auto& [name, entry] : one) names.insert(name);
  for (const auto& [name, entry] : other) names.insert(name);
  const auto described = [&](const Entries& entries, const std::string& name) {
    const auto found = entries.find(name);
    return found == entries.end() ? std::string("none") : text(found->second);
  };
  for (const std::string& name : names) {
    const std::string first = described(one, name);
    const std::string second = described(other, name);
    if (first == second) continue;
    lines.push_back(what + name + ": " + before + " " + first + ", " + now + " " + second);
  }
}

std::string shortened(const std::string& text) {
  constexpr std::size_t kLongest = 120;
  return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

}  // namespace

std::map<std::string, std::string> givenSettings(const RunDescription& run) {
  std::map<std::string, std::string> given;
  for (const auto& [name, setting] : run.settings) {
    if (!setting.is_default) given.emplace(name, setting.value);
  }
  return given;
}

void describeContents(const DatasetInfo& dataset, RunDescription& run) {
  for (const ClassInfo& each : dataset.classes) run.classes.push_back({each.id, each.name});
  for (const MotionInfo& each : dataset.motions) {
    run.motions.push_back({each.name, each.first_instant, each.instant_count, each.rate});
  }
  for (const CameraDescription& each : dataset.cameras) {
    run.cameras.push_back({each.name, each.frame, each.model.width(), each.model.height(),
                           each.model, each.intrinsics_vary});
  }
  for (const ObjectInfo& each : dataset.objects) {
    run.objects.push_back({each.name,
                           each.class_id,
                           each.id,
                           each.keypoint_names,
                           each.skeleton,
                           each.model_varies,
                           {},
                           each.part_names});
  }
  run.world_classes = dataset.world_classes;
  run.splits = dataset.splits;
  run.global_frame = dataset.global_frame;
  run.scene_count = dataset.scene_count;
}

std::vector<CreditInfo> creditInfos(const std::map<std::string, RunDescription::Credit>& credits) {
  std::map<std::pair<std::string, std::string>, std::set<std::string>> files;
  for (const auto& [path, credit] : credits) {
    const std::filesystem::path file(path);
    files[{credit.license, credit.author}].insert(
        (file.parent_path().filename() / file.filename()).string());
  }
  std::vector<CreditInfo> infos;
  for (const auto& [named, of] : files) {
    infos.push_back({named.second, named.first, {of.begin(), of.end()}});
  }
  return infos;
}

std::string settingsDigest(const RunDescription& run) {
  Digest digest;
  const auto add = [&digest](const std::string& text) {
    digest.add(std::to_string(text.size()) + ":" + text);
  };
  for (const auto& [name, value] : givenSettings(run)) {
    add(name);
    add(value);
  }
  for (const auto& [path, input] : run.inputs) {
    add(path);
    add(input.digest);
  }
  return digest.text();
}

std::vector<std::string> differences(const RunDescription& one, const RunDescription& other,
                                     const std::string& before, const std::string& now) {
  std::vector<std::string> lines;
  compare("", givenSettings(one), givenSettings(other), before, now, shortened, lines);
  compare(
      "the file ", one.inputs, other.inputs, before, now,
      [](const RunDescription::Input& input) {
        return std::to_string(input.bytes) + " bytes (SHA-256 " + input.digest.substr(0, 12) + ")";
      },
      lines);
  compare(
      "software ", one.software, other.software, before, now,
      [](const std::string& version) { return version; }, lines);
  if (lines.empty() && one.scene_count != other.scene_count) {
    lines.push_back("the number of scenes: " + before + " " + std::to_string(one.scene_count) +
                    ", " + now + " " + std::to_string(other.scene_count));
  }
  return lines;
}

}  // namespace synthetic_dataset::output
