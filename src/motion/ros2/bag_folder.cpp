#include "motion/ros2/bag_folder.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <tuple>

#include "base/yaml_value.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::motion {
namespace {

namespace fs = std::filesystem;

const Value* entryOf(const Value* value, const std::string& name) {
  const auto* map = value == nullptr ? nullptr : value->as<Value::Map>();
  if (map == nullptr) return nullptr;
  const auto found = map->find(name);
  return found == map->end() ? nullptr : &found->second;
}

/// The names of the files that the metadata list (https://github.com/ros2/rosbag2, rosbag2_storage,
/// MetadataIo). Older versions put the folder before the names; all files are in that folder.
std::vector<std::string> namedFiles(const fs::path& metadata) {
  const Value content = base::loadYamlFile(metadata.string());
  const Value* const information = entryOf(&content, "rosbag2_bagfile_information");
  if (information == nullptr) {
    throw Error("metadata.yaml has no 'rosbag2_bagfile_information'");
  }
  std::vector<std::string> files;
  const Value* const paths = entryOf(information, "relative_file_paths");
  const auto* list = paths == nullptr ? nullptr : paths->as<Value::List>();
  if (list == nullptr) return files;
  for (const Value& each : *list) {
    const auto* path = each.as<std::string>();
    if (path == nullptr) throw Error("metadata.yaml names a file that is no text");
    files.push_back(fs::path(*path).filename().string());
  }
  return files;
}

/// Sorted so that "bag_2.mcap" comes before "bag_10.mcap".
std::vector<std::string> filesIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!hasStorageName(name) || !isFile(entry->path())) continue;
    // `ros2 bag play` leaves the file that it decompresses next to the compressed one.
    const bool is_compressed = entry->path().extension() == ".zstd";
    if (is_compressed && isFile(folder / entry->path().stem())) continue;
    names.push_back(name);
  }
  std::sort(names.begin(), names.end(), [](const std::string& a, const std::string& b) {
    return std::forward_as_tuple(a.size(), a) < std::forward_as_tuple(b.size(), b);
  });
  return names;
}

}  // namespace

bool isFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool hasStorageName(const std::string& file) {
  fs::path name = fs::path(file).filename();
  if (name.extension() == ".zstd") name = name.stem();
  return name.extension() == ".db3" || name.extension() == ".mcap";
}

std::vector<std::string> storageFiles(const std::string& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return {path};
  const fs::path folder(path);
  const fs::path metadata = folder / "metadata.yaml";
  std::vector<std::string> names;
  if (isFile(metadata)) names = namedFiles(metadata);
  if (names.empty()) names = filesIn(folder);
  std::vector<std::string> files;
  for (const std::string& name : names) {
    const fs::path file = folder / name;
    const fs::path plain = folder / fs::path(name).stem();  // decompressed by rosbag2
    const bool is_plain = !isFile(file) && file.extension() == ".zstd" && isFile(plain);
    files.push_back((is_plain ? plain : file).string());
    if (isFile(files.back())) continue;
    throw Error("metadata.yaml names the file '" + name + "', which is not in the folder");
  }
  if (files.empty()) throw Error("has no file of rosbag2 (.db3 or .mcap)");
  return files;
}

}  // namespace synthetic_dataset::motion
