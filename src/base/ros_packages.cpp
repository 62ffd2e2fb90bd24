#include "base/ros_packages.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include <tinyxml2.h>

#include "base/input_file.h"
#include "base/xml_text.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::base {
namespace {

namespace fs = std::filesystem;

/// The greatest depth of nested folders; rospack has the same limit.
constexpr int kDeepestFolder = 1000;

bool isFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

/// "${prefix}/models:${prefix}" as two folders.
std::vector<std::string> foldersIn(const char* attribute, const fs::path& prefix) {
  constexpr std::string_view kPrefix = "${prefix}";
  std::vector<std::string> folders;
  std::istringstream list(attribute != nullptr ? attribute : "");
  for (std::string folder; std::getline(list, folder, ':');) {
    for (std::size_t at = folder.find(kPrefix); at != std::string::npos;
         at = folder.find(kPrefix, at + prefix.string().size())) {
      folder.replace(at, kPrefix.size(), prefix.string());
    }
    if (!folder.empty()) folders.push_back((prefix / folder).lexically_normal().string());
  }
  return folders;
}

void readExports(const tinyxml2::XMLElement& manifest, RosPackage& package) {
  const auto add = [&](const char* attribute, std::vector<std::string>& to) {
    for (std::string& folder : foldersIn(attribute, package.folder)) {
      to.push_back(std::move(folder));
    }
  };
  for (const auto* exported = manifest.FirstChildElement("export"); exported != nullptr;
       exported = exported->NextSiblingElement("export")) {
    for (const auto* each = exported->FirstChildElement(); each != nullptr;
         each = each->NextSiblingElement()) {
      const std::string_view name = each->Name();
      if (name != "gazebo_ros" && name != "gazebo") continue;
      add(each->Attribute("gazebo_model_path"), package.gazebo_models);
      add(each->Attribute("gazebo_media_path"), package.gazebo_media);
    }
  }
}

std::string trimmedText(const tinyxml2::XMLElement* element) {
  const char* text = element != nullptr ? element->GetText() : nullptr;
  std::string result = text != nullptr ? text : "";
  constexpr const char* kBlanks = " \t\r\n";
  result.erase(0, std::min(result.find_first_not_of(kBlanks), result.size()));
  result.erase(result.find_last_not_of(kBlanks) + 1);
  return result;
}

/// Collects packages, folder by folder.
class Search {
 public:
  void look(const fs::path& folder, int depth) {
    std::error_code error;
    if (depth > kDeepestFolder || !fs::is_directory(folder, error)) return;
    if (isFile(folder / "CATKIN_IGNORE")) return;
    for (const char* manifest : {"package.xml", "manifest.xml"}) {
      if (isFile(folder / manifest)) return read(folder, folder / manifest);
    }
    if (isFile(folder / "rospack_nosubdirs")) return;
    if (!seen_.insert(fs::canonical(folder, error)).second) return;  // a circular link
    std::set<fs::path> inner;  // sorted, as the first package of a name counts
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
      if (entry->path().filename().string().front() != '.') inner.insert(entry->path());
    }
    for (const fs::path& each : inner) look(each, depth + 1);
  }

  RosPackages found;

 private:
  void read(const fs::path& folder, const fs::path& manifest) {
    tinyxml2::XMLDocument document;
    std::string text;
    try {
      text = readInput(manifest);
    } catch (const Error& error) {
      found.broken.emplace_back(folder, error.what());
      return;
    }
    const auto fault = parseXml(document, text);
    const tinyxml2::XMLElement* root = document.RootElement();
    const std::string_view kind = root != nullptr ? root->Name() : "";
    if (fault) {
      found.broken.emplace_back(folder, manifest.string() + ": line " +
                                            std::to_string(fault->line) +
                                            " cannot be read as XML (" + fault->reason + ")");
      return;
    }
    if (kind != "package") {
      if (manifest.filename() == "manifest.xml") return;  // for example, a list of Gazebo models
      found.broken.emplace_back(folder, manifest.string() + ": has no <package>");
      return;
    }
    RosPackage package;
    package.folder = folder;
    package.name = trimmedText(root->FirstChildElement("name"));
    if (package.name.empty()) package.name = folder.filename().string();
    if (!names_.insert(package.name).second) return;
    readExports(*root, package);
    found.sound.push_back(std::move(package));
  }

  std::set<fs::path> seen_;
  std::set<std::string> names_;
};

}  // namespace

std::string rosPackagePath() {
  std::string path = variable("ROS_PACKAGE_PATH");
  std::istringstream prefixes(variable("AMENT_PREFIX_PATH"));
  for (std::string prefix; std::getline(prefixes, prefix, ':');) {
    if (!prefix.empty()) path += (path.empty() ? "" : ":") + prefix + "/share";
  }
  return path.empty() ? "/usr/share" : path + ":/usr/share";
}

std::vector<fs::path> installedPackages(const fs::path& entry) {
  std::set<fs::path> packages;
  if (entry.filename() != "share") return {};
  std::error_code error;
  for (auto each = fs::directory_iterator(entry, error); !error && each != end(each);
       each.increment(error)) {
    if (isFile(each->path() / "package.xml")) packages.insert(each->path());
  }
  return {packages.begin(), packages.end()};
}

RosPackages findRosPackages(const std::string& package_path) {
  Search search;
  std::istringstream entries(package_path);
  for (std::string entry; std::getline(entries, entry, ':');) {
    const std::vector<fs::path> installed = installedPackages(entry);
    for (const fs::path& folder : installed) search.look(folder, 1);
    if (installed.empty() && !entry.empty()) search.look(entry, 1);
  }
  return std::move(search.found);
}

std::string didYouMeanPackage(const std::string& name) {
  std::vector<std::string> names;
  for (const RosPackage& each : findRosPackages(rosPackagePath()).sound) names.push_back(each.name);
  return didYouMean(name, names);
}

}  // namespace synthetic_dataset::base
