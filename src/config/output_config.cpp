#include "config/output_config.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "config/checked_values.h"

namespace synthetic_dataset::config {
namespace {

/// The text of an entry's member, or nothing.
std::string memberText(const Value& entry, const std::string& member) {
  const auto* map = entry.as<Value::Map>();
  if (map == nullptr) return "";
  const auto found = map->find(member);
  const auto* text = found == map->end() ? nullptr : found->second.as<std::string>();
  return text == nullptr ? "" : *text;
}

/// Names and types of the writers; left out, the original's three.
std::vector<std::pair<std::string, std::string>> readWriterNames(const Parameters& root) {
  const auto given = root.maybe<Value>("writers");
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

OutputConfig readOutput(const Parameters& root) {
  OutputConfig output;
  output.folder = absolutePath(root.maybe<std::string>("output_folder").value_or(""));
  const auto if_exists = root.optional<std::string>("if_exists", "error");
  if (if_exists != "error" && if_exists != "overwrite") {
    root.addError("if_exists", "found '" + if_exists + "'; it should be error or overwrite");
  }
  output.overwrite = if_exists == "overwrite";
  const Parameters image = root.group("image");
  output.png_compression = numberBetween(image, "png_compression", output.png_compression, 0, 9);
  output.jpeg_quality = numberBetween(image, "jpeg_quality", output.jpeg_quality, 1, 100);
  return output;
}

std::vector<WriterConfig> readWriters(const Parameters& root, const std::string& output_folder) {
  std::vector<WriterConfig> writers;
  std::set<std::string> seen;
  for (const auto& [name, type] : readWriterNames(root)) {
    if (!seen.insert(name).second) {
      root.addError("writers", "found the name '" + name + "' more than once");
      continue;
    }
    const Parameters group = root.group(name);
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

std::string commonFolder(const std::vector<WriterConfig>& writers) {
  if (writers.empty()) return "";
  std::filesystem::path common = writers.front().output_folder;
  for (const WriterConfig& writer : writers) {
    std::filesystem::path shared;
    const std::filesystem::path other = writer.output_folder;
    for (auto a = common.begin(), b = other.begin();
         a != common.end() && b != other.end() && *a == *b; ++a, ++b) {
      shared /= *a;
    }
    common = shared;
  }
  // Folders that share only the root have no place in common for a manifest.
  if (common == common.root_path()) return writers.front().output_folder;
  return common.string();
}

}  // namespace synthetic_dataset::config
