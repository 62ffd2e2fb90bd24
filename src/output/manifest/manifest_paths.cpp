#include "output/manifest/manifest_paths.h"

#include "output/files/file_name_rules.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/relative_path.h"

namespace synthetic_dataset::output {

std::string listedPath(const std::string& folder, const std::string& path) {
  const bool is_below = path.size() > folder.size() && liesWithin(path, folder);
  if (!is_below) return path;
  const std::string below = path.substr(folder.size() + 1);
  return below.empty() ? "./" : below;
}

std::string absoluteFrom(const std::string& folder, const std::string& listed) {
  if (!listed.empty() && listed.front() == '/') return listed;
  if (listed == "./" || listed == ".") return folder + "/";
  const bool is_folder = !listed.empty() && listed.back() == '/';
  if (relativePathProblem(is_folder ? listed.substr(0, listed.size() - 1) : listed)) {
    throw Error("the manifest in '" + folder + "' lists the path '" + listed + "'");
  }
  return folder + "/" + listed;
}

}  // namespace synthetic_dataset::output
