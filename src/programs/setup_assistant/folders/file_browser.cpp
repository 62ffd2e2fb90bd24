#include "programs/setup_assistant/folders/file_browser.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <system_error>
#include <vector>

#include "motion/bag/bag.h"
#include "motion/bag/ros2_bag.h"
#include "programs/setup_assistant/web/http_message.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

namespace fs = std::filesystem;

std::string beginningOf(const fs::path& file) {
  constexpr std::size_t kBeginning = 4096;
  std::ifstream stream(file, std::ios::binary);
  std::string text(kBeginning, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

bool beginsWith(const fs::path& file, const std::vector<std::string>& words) {
  const std::string beginning = beginningOf(file);
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return beginning.find(word) != std::string::npos;
  });
}

Value folderValue(const fs::path& folder, const std::string& name) {
  return Value::Map{{"name", Value(name)}, {"path", Value(folder.string())}};
}

Value rootsValue(const AllowedFolders& allowed) {
  Value::List folders;
  for (const fs::path& root : allowed.roots()) folders.push_back(folderValue(root, root.string()));
  return Value::Map{{"folder", Value()},
                    {"parent", Value()},
                    {"folders", Value(folders)},
                    {"files", Value(Value::List{})}};
}

/// The size of a ROS 2 bag folder.
std::int64_t sizeOfBag(const std::string& folder) {
  std::int64_t size = 0;
  try {
    for (const std::string& file : motion::filesOfBag(folder)) {
      std::error_code error;
      const auto bytes = fs::file_size(file, error);
      if (!error) size += static_cast<std::int64_t>(bytes);
    }
  } catch (const Error&) {
    return 0;  // the error will be reported when the bag is read
  }
  return size;
}

std::vector<fs::directory_entry> visibleEntries(const AllowedFolders& allowed,
                                                const fs::path& folder) {
  std::vector<fs::directory_entry> entries;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().filename().string().front() == '.') continue;
    std::error_code broken;
    const fs::path resolved = fs::canonical(entry.path(), broken);
    if (!broken && allowed.holds(resolved)) entries.push_back(entry);
  }
  if (error) throw HttpError(403, "'" + folder.string() + "': " + error.message());
  std::sort(entries.begin(), entries.end());
  return entries;
}

}  // namespace

std::string kindOfFile(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".bag" || motion::isBagPath(file.string())) return "bag";
  if (extension == ".world") return "world";
  if (extension == ".urdf" || extension == ".xacro") return "model";
  if (extension == ".sdf" || extension == ".jinja")
    return beginsWith(file, {"<world"}) ? "world" : "model";
  if (extension == ".ini") return "calibration";
  if (extension == ".yaml" || extension == ".yml") {
    return beginsWith(file, {"camera_matrix", "camera_model", "intrinsics"}) ? "calibration"
                                                                             : "yaml";
  }
  return "other";
}

Value listFolder(const AllowedFolders& allowed, const std::string& folder,
                 const std::set<std::string>& kinds) {
  if (folder.empty()) return rootsValue(allowed);
  const fs::path resolved = allowed.resolve(folder);
  if (!fs::is_directory(resolved)) {
    throw HttpError(404, "'" + folder + "': found a file; a folder is needed");
  }
  Value::List folders;
  Value::List files;
  for (const auto& entry : visibleEntries(allowed, resolved)) {
    std::error_code error;
    const std::string name = entry.path().filename().string();
    if (entry.is_directory(error)) {
      folders.push_back(folderValue(entry.path(), name));
      const bool wants_bags = kinds.empty() || kinds.count("any") != 0 || kinds.count("bag") != 0;
      if (!wants_bags || !motion::isRos2Bag(entry.path().string())) continue;
      files.push_back(Value::Map{{"name", Value(name)},
                                 {"path", Value(entry.path().string())},
                                 {"size", Value(sizeOfBag(entry.path().string()))},
                                 {"kind", Value("bag")}});
    } else if (entry.is_regular_file(error)) {
      const std::string kind = kindOfFile(entry.path());
      if (!kinds.empty() && kinds.count("any") == 0 && kinds.count(kind) == 0) continue;
      files.push_back(Value::Map{{"name", Value(name)},
                                 {"path", Value(entry.path().string())},
                                 {"size", Value(static_cast<std::int64_t>(entry.file_size(error)))},
                                 {"kind", Value(kind)}});
    }
  }
  const bool is_root = std::find(allowed.roots().begin(), allowed.roots().end(), resolved) !=
                           allowed.roots().end() &&
                       !allowed.holds(resolved.parent_path());
  return Value::Map{{"folder", Value(resolved.string())},
                    {"parent", is_root ? Value() : Value(resolved.parent_path().string())},
                    {"folders", Value(folders)},
                    {"files", Value(files)}};
}

}  // namespace synthetic_dataset::programs
