#include "config/readers.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>

#include "config/checked_values.h"

namespace synthetic_dataset::config {
namespace {

/// The text of an entry's member, or "".
std::string memberText(const Value& entry, const std::string& member) {
  const auto* map = entry.as<Value::Map>();
  if (map == nullptr) return "";
  const auto found = map->find(member);
  const auto* text = found == map->end() ? nullptr : found->second.as<std::string>();
  return text == nullptr ? "" : *text;
}

/// Reads `shard: {index: 2, count: 8}`; nullopt for the whole run.
std::optional<output::Shard> readShard(Parameters& root) {
  if (!root.has("shard")) return std::nullopt;
  Parameters group = root.group("shard");
  output::Shard shard;
  if (!group.has("count") || !group.has("index")) {
    for (const char* name : {"count", "index"}) (void)group.required<std::int64_t>(name);
    return std::nullopt;
  }
  shard.count = group.required<std::int64_t>("count");
  shard.index = group.required<std::int64_t>("index");
  constexpr std::int64_t kMost = 100000;
  if (shard.count < 1 || shard.count > kMost) {
    group.addError("count", "found " + std::to_string(shard.count) + "; it should be 1 to " +
                                std::to_string(kMost));
    return std::nullopt;
  }
  if (shard.index < 0 || shard.index >= shard.count) {
    group.addError("index", "found " + std::to_string(shard.index) + "; it should be 0 to " +
                                std::to_string(shard.count - 1) + ", as count is " +
                                std::to_string(shard.count));
    return std::nullopt;
  }
  return shard;
}

/// Names and types of the writers. If they are left out and there is a group of one of
/// nn_data_collection's three writers, these three.
std::vector<std::pair<std::string, std::string>> readWriterNames(Parameters& root) {
  const auto given = root.maybe<Value>("writers");
  const auto isOfOriginal = [&] {
    return root.has("bounding_shape") || root.has("yolo") || root.has("stvnet");
  };
  if (!given && !isOfOriginal()) {
    root.addError("writers",
                  "missing; it should say which formats are made, such as `writers: [{name: coco, "
                  "type: synthetic_dataset/Coco}]` (docs/formats.md has them all)");
    return {};
  }
  if (!given) {
    return {{"bounding_shape", "synthetic_dataset/BoundingShape"},
            {"yolo", "synthetic_dataset/Yolo"},
            {"stvnet", "synthetic_dataset/StvNet"}};
  }
  const std::string should = "; it should be a list of {name: ..., type: ...}";
  const auto* list = given->as<Value::List>();
  if (list == nullptr || list->empty()) {
    root.addError("writers",
                  "found " + (list == nullptr ? given->kind() : "an empty list") + should);
    return {};
  }
  std::vector<std::pair<std::string, std::string>> writers;
  for (const Value& entry : *list) {
    const std::string name = memberText(entry, "name");
    const std::string type = memberText(entry, "type");
    const bool has_control = std::any_of(name.begin(), name.end(), [](char c) {
      return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    });
    if (has_control || name == "." || name.find("..") != std::string::npos) {
      root.addError("writers", "found the name '" + name +
                                   "', which is also a folder's; it should have neither control "
                                   "characters nor '..'");
      continue;
    }
    if (name.empty() || type.empty() || entry.as<Value::Map>()->size() != 2) {
      root.addError("writers", "found the entry " + entry.text() + should);
      continue;
    }
    writers.emplace_back(name, type);
  }
  return writers;
}

}  // namespace

output::StoreOptions readOutput(Parameters root) {
  output::StoreOptions output;
  output.folder = absolutePath(root.maybe<std::string>("output_folder").value_or(""));
  output.if_exists = choice<output::IfExists>(root, "if_exists",
                                              {{"resume", output::IfExists::kResume},
                                               {"overwrite", output::IfExists::kOverwrite},
                                               {"error", output::IfExists::kError}});
  output.sync = choice<output::Sync>(root, "sync",
                                     {{"batch", output::Sync::kBatch},
                                      {"scene", output::Sync::kScene},
                                      {"off", output::Sync::kOff}});
  output.shard = readShard(root);
  Parameters image = root.group("image");
  output.png_compression = image.optionalBetween("png_compression", output.png_compression, 0, 9);
  output.jpeg_quality = image.optionalBetween("jpeg_quality", output.jpeg_quality, 1, 100);
  return output;
}

int readProcesses(Parameters root, bool is_shard) {
  constexpr int kMost = 1024;
  const int processes = root.optionalBetween("processes", 1, 1, kMost);
  if (!is_shard || processes == 1) return processes;
  root.addError("processes", "found " + std::to_string(processes) +
                                 " and a shard, which one process makes; it should be 1, or " +
                                 "shard be left out");
  return 1;
}

std::set<std::int64_t> readOnlyScenes(Parameters root) {
  const auto given = root.maybe<Value>("only_scenes");
  if (!given) return {};
  const auto* list = given->as<Value::List>();
  const Value::List one{*given};
  std::set<std::int64_t> scenes;
  for (const Value& each : list != nullptr ? *list : one) {
    const auto* number = each.as<std::int64_t>();
    if (number == nullptr || *number < 0) {
      root.addError("only_scenes", "found " + given->text() +
                                       "; it should be a list of scenes' numbers, as their files' "
                                       "names have them");
      return {};
    }
    scenes.insert(*number);
  }
  if (scenes.empty()) {
    root.addError("only_scenes", "found an empty list; it should name scenes, or be left out");
  }
  return scenes;
}

std::vector<output::WriterOptions> readWriters(Parameters root, const std::string& output_folder) {
  std::vector<output::WriterOptions> writers;
  std::set<std::string> seen;
  for (const auto& [name, type] : readWriterNames(root)) {
    if (!seen.insert(name).second) {
      root.addError("writers", "found the name '" + name + "' more than once");
      continue;
    }
    Parameters group = root.group(name);
    auto folder = group.maybe<std::string>("output_folder");
    if (!folder && output_folder.empty()) {
      group.addError("output_folder",
                     "required, but missing (or give the whole run an output_folder)");
    }
    if (folder && folder->empty()) {
      group.addError("output_folder", "found an empty text; it should be a folder");
      continue;
    }
    if (!folder) folder = output_folder + "/" + name;
    writers.push_back({name, type, folderPath(*folder), group});
  }
  return writers;
}

std::string commonFolder(const std::vector<output::WriterOptions>& writers) {
  if (writers.empty()) return "";
  std::filesystem::path common = writers.front().output_folder;
  for (const output::WriterOptions& writer : writers) {
    std::filesystem::path shared;
    const std::filesystem::path other = writer.output_folder;
    for (auto a = common.begin(), b = other.begin();
         a != common.end() && b != other.end() && *a == *b; ++a, ++b) {
      shared /= *a;
    }
    common = shared;
  }
  // Folders with only the root in common have no common place for a manifest.
  if (common == common.root_path()) return writers.front().output_folder;
  return common.string();
}

}  // namespace synthetic_dataset::config
