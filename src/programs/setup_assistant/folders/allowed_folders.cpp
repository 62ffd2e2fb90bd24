#include "programs/setup_assistant/folders/allowed_folders.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <system_error>

#include "output/files/file_name_rules.h"
#include "programs/setup_assistant/web/http_message.h"
#include "run/setup/package_index.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {

namespace fs = std::filesystem;

AllowedFolders::AllowedFolders(const fs::path& file, const std::vector<std::string>& more) {
  roots_.push_back(fs::canonical(fs::absolute(file).parent_path()));
  for (const std::string& folder : more) {
    if (!fs::is_directory(folder)) throw Error("--folder: '" + folder + "' is not a folder");
    add(folder);
  }
  if (const auto own = run::rosPackageFinder()("synthetic_dataset")) add(*own);
  for (const char* variable : {"ROS_PACKAGE_PATH", "GAZEBO_MODEL_PATH", "GAZEBO_RESOURCE_PATH",
                               "GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH", "SDF_PATH"}) {
    addListed(variable);
  }
}

void AllowedFolders::add(const std::string& folder) {
  std::error_code none;
  const fs::path resolved = fs::canonical(folder, none);
  if (none || !fs::is_directory(resolved, none) || resolved == resolved.root_path()) return;
  if (std::find(roots_.begin(), roots_.end(), resolved) == roots_.end()) roots_.push_back(resolved);
}

void AllowedFolders::addListed(const char* variable) {
  const char* value = std::getenv(variable);
  std::istringstream folders(value == nullptr ? "" : value);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (!folder.empty()) add(folder);
  }
}

fs::path AllowedFolders::resolve(const fs::path& path) const {
  std::error_code error;
  const fs::path resolved = fs::canonical(path.is_absolute() ? path : home() / path, error);
  if (!error && holds(resolved)) return resolved;
  throw HttpError(403, "'" + path.string() +
                           "': found no such file in the folders that this page may read; "
                           "start setup_assistant with `--folder DIR` to add one");
}

bool AllowedFolders::holds(const fs::path& resolved) const {
  return std::any_of(roots_.begin(), roots_.end(),
                     [&](const fs::path& root) { return isBelow(resolved, root); });
}

bool isBelow(const fs::path& path, const fs::path& folder) {
  return output::liesWithin(path.string(), folder.string());
}

}  // namespace synthetic_dataset::programs
