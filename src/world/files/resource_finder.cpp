#include "world/files/resource_finder.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "base/input_file.h"
#include "base/ros_packages.h"
#include "world/files/fuel.h"
#include "world/files/gazebo_folders.h"
#include "world/files/text.h"

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

constexpr const char* kModelVariables[] = {"GAZEBO_MODEL_PATH", "GZ_SIM_RESOURCE_PATH",
                                           "IGN_GAZEBO_RESOURCE_PATH", "SDF_PATH"};

/// Subfolders of a resource folder to search, as in Gazebo's SystemPaths
/// (gazebo/common/SystemPaths.cc).
constexpr const char* kMediaSuffixes[] = {"", "models", "media/models", "Media/models"};

/// The two parts of a URI; a plain path has no scheme.
struct Uri {
  std::string scheme;
  std::string rest;
};

Uri parse(const std::string& text) {
  const std::size_t end = text.find("://");
  if (end == std::string::npos) return {"", text};
  const std::string rest = text.substr(end + 3);
  const bool is_twice = text.substr(0, end) == "file" && rest.find("://") != std::string::npos;
  if (is_twice) return parse(rest);  // "file://$(find pkg)/x" has become "file://package://pkg/x"
  return {text.substr(0, end), rest};
}

/// The path made absolute, without `.`, `..` or a trailing slash, so that messages read well.
fs::path tidy(const fs::path& path) {
  fs::path result = fs::absolute(path).lexically_normal();
  return result.has_filename() ? result : result.parent_path();
}

/// A model's name as used for folders: "Ground Plane" is "ground_plane".
std::string folderName(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
    return c == ' ' ? '_' : static_cast<char>(std::tolower(c));
  });
  return name;
}

/// Splits "name/rest" into the name and "/rest".
std::pair<std::string, std::string> splitName(const std::string& text) {
  const std::size_t end = text.find('/');
  if (end == std::string::npos) return {text, ""};
  return {text.substr(0, end), text.substr(end)};
}

/// The model that contains `folder`, if it has the wanted name: files of a model in Fuel's cache,
/// whose folder is named after its version, refer to their meshes as `model://name/...`.
std::optional<fs::path> ownModel(const std::string& wanted, const fs::path& folder) {
  const std::string name = folderName(wanted);
  for (fs::path model = folder; model.has_relative_path(); model = model.parent_path()) {
    std::error_code ignored;
    if (!fs::exists(model / "model.config", ignored)) continue;
    const bool same = folderName(model.filename().string()) == name ||
                      folderName(model.parent_path().filename().string()) == name;
    return same ? std::optional(model) : std::nullopt;
  }
  return std::nullopt;
}

/// The package of the given name that contains `folder`, or that is next to the one that does: its
/// workspace may not have been sourced.
std::optional<fs::path> ownPackage(const std::string& name, const fs::path& folder) {
  if (name.empty() || name == "..") return std::nullopt;
  for (fs::path own = folder; own.has_relative_path(); own = own.parent_path()) {
    std::error_code ignored;
    if (!fs::exists(own / "package.xml", ignored)) continue;
    for (const fs::path& each : {own, own.parent_path() / name}) {
      if (each.filename() == name && fs::exists(each / "package.xml", ignored)) return each;
    }
    return std::nullopt;
  }
  return std::nullopt;
}

std::vector<std::string> spellings(const std::string& uri) {
  std::vector<std::string> all = {uri};
  const std::string decoded = percentDecoded(uri);
  for (const std::string& other : {decoded, withSlashes(uri), withSlashes(decoded)}) {
    if (std::find(all.begin(), all.end(), other) == all.end()) all.push_back(other);
  }
  return all;
}

bool isOf(const std::string& uri, std::initializer_list<const char*> schemes) {
  const std::string scheme = parse(uri).scheme;
  return std::find(schemes.begin(), schemes.end(), scheme) != schemes.end();
}

}  // namespace

bool isWithin(const fs::path& path, const fs::path& folder) {
  const fs::path inner = tidy(path);
  const fs::path outer = tidy(folder);
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

/// Paths to which a URI may refer, in the order in which they are tried.
struct ResourceFinder::Candidates {
  std::vector<fs::path> paths;
  std::vector<std::string> shown;  ///< where they are, for messages: each folder once
  bool lead_out = false;           ///< one path would, and was left out

  void add(const fs::path& path, const fs::path& place) {
    paths.push_back(tidy(path));
    const std::string text = tidy(place).string();
    if (std::find(shown.begin(), shown.end(), text) == shown.end()) shown.push_back(text);
  }

  /// Adds a path below a folder that is searched.
  void addBelow(const fs::path& folder, const std::string& rest) {
    const fs::path path = folder / fs::path(rest).relative_path();
    if (isWithin(path, folder)) add(path, folder);
  }

  /// Adds a path in the folder of a package or model; it may lead to the folder's neighbours.
  void addIn(const fs::path& named_folder, const std::string& rest) {
    const fs::path path(named_folder.string() + rest);
    lead_out = lead_out || !isWithin(path, tidy(named_folder).parent_path());
    if (isWithin(path, tidy(named_folder).parent_path())) add(path, path);
  }
};

ResourceFinder::ResourceFinder(std::vector<std::string> model_folders, PackageFinder package_finder,
                               ExportFinder export_finder)
    : model_folders_(std::move(model_folders)),
      media_folders_(foldersOf("GAZEBO_RESOURCE_PATH")),
      fuel_caches_(fuelCaches()),
      package_finder_(std::move(package_finder)),
      export_finder_(std::move(export_finder)) {
  const auto append = [](const std::string& folder, std::vector<std::string>& to) {
    if (std::find(to.begin(), to.end(), folder) == to.end()) to.push_back(folder);
  };
  for (const char* variable : kModelVariables) {
    for (const std::string& folder : foldersOf(variable)) append(folder, model_folders_);
  }
  if (const char* home = std::getenv("HOME")) {
    append(std::string(home) + "/.gazebo/models", model_folders_);
  }
  for (const fs::path& gazebo : installedGazebos()) {
    append((gazebo / "models").string(), model_folders_);
    append(gazebo.string(), media_folders_);
  }
}

void ResourceFinder::addModel(const std::string& rest, const std::vector<std::string>& folders,
                              Candidates& to) {
  if (!isWithin(fs::path("/any") / fs::path(rest).relative_path(), "/any")) to.lead_out = true;
  for (const std::string& folder : folders) to.addBelow(folder, rest);
}

void ResourceFinder::addPackage(const std::string& rest, Candidates& to) const {
  const auto [package, inner] = splitName(rest);
  if (!package_finder_ || package.empty()) return;
  if (const auto folder = package_finder_(package)) to.addIn(*folder, inner);
}

void ResourceFinder::addPlain(const std::string& rest, const std::vector<std::string>& media,
                              const std::vector<std::string>& models, Candidates& to) {
  if (fs::path(rest).is_absolute()) return;
  for (const std::string& folder : media) {
    for (const char* suffix : kMediaSuffixes)
      to.addBelow(folder, (suffix / fs::path(rest)).string());
  }
  for (const std::string& folder : models) to.addBelow(folder, rest);
}

ResourceFinder::Candidates ResourceFinder::candidates(const std::string& uri,
                                                      const fs::path& folder) const {
  Candidates result;
  const Uri parts = parse(uri);
  if (parts.rest.empty() || uri.find('\0') != std::string::npos) return result;
  if (parts.scheme == "model") {
    addModel(parts.rest, model_folders_, result);
    addPackage(parts.rest, result);
    const auto [name, inner] = splitName(parts.rest);
    if (const auto model = ownModel(name, folder)) result.addIn(*model, inner);
  } else if (parts.scheme == "package") {
    addPackage(parts.rest, result);
    addModel(parts.rest, model_folders_, result);
    const auto [name, inner] = splitName(parts.rest);
    if (const auto package = ownPackage(name, folder)) result.addIn(*package, inner);
  } else if (parts.scheme.empty() || parts.scheme == "file") {
    const fs::path path = folder / parts.rest;  // an absolute `rest` replaces the folder
    result.add(path, path);
    addPlain(parts.rest, media_folders_, model_folders_, result);
  } else if (const auto fuel = parseFuelUri(uri)) {
    for (const fs::path& path : fuelPlaces(*fuel, fuel_caches_)) {
      const auto holds = [&](const fs::path& cache) { return isWithin(path, cache); };
      if (std::any_of(fuel_caches_.begin(), fuel_caches_.end(), holds)) {
        result.add(path, path);
      } else {
        result.lead_out = true;
      }
    }
  }
  return result;
}

ResourceFinder::Candidates ResourceFinder::exportedCandidates(const std::string& uri) const {
  Candidates result;
  const Uri parts = parse(uri);
  if (!export_finder_ || parts.rest.empty() || uri.find('\0') != std::string::npos) return result;
  if (isOf(uri, {"model", "package"})) {
    addModel(parts.rest, export_finder_().models, result);
  } else if (isOf(uri, {"", "file"}) && !fs::path(parts.rest).is_absolute()) {
    const ExportedFolders exported = export_finder_();
    addPlain(parts.rest, exported.media, exported.models, result);
  }
  return result;
}

std::vector<std::string> ResourceFinder::mediaFolders() const {
  std::vector<std::string> folders = media_folders_;
  if (!export_finder_) return folders;
  for (const std::string& exported : export_finder_().media) folders.push_back(exported);
  return folders;
}

std::optional<fs::path> ResourceFinder::at(const fs::path& path) const {
  std::error_code ignored;  // set if nothing is there
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_regular_file(status)) found_.insert(path);
  // A pipe or a device is reported where it would be opened (base/input_file.h).
  if (fs::exists(status)) return path;
  missed_.insert(path);
  return std::nullopt;
}

std::optional<fs::path> ResourceFinder::find(const std::string& uri, const fs::path& folder) const {
  const auto firstOf = [&](const Candidates& candidates) -> std::optional<fs::path> {
    for (const fs::path& path : candidates.paths) {
      if (auto found = at(path)) return found;
    }
    return std::nullopt;
  };
  const std::vector<std::string> all = spellings(uri);
  for (const std::string& spelling : all) {
    if (auto found = firstOf(candidates(spelling, folder))) return found;
  }
  for (const std::string& spelling : all) {
    if (auto found = firstOf(exportedCandidates(spelling))) return found;
  }
  unresolved_.insert(uri);
  if (leadsOut(uri, folder)) {
    refuse("'" + uri + "' in a file of " + folder.string() +
           " leads out of the folders that it may name, and is not read");
  }
  return std::nullopt;
}

bool ResourceFinder::leadsOut(const std::string& uri, const fs::path& folder) const {
  const std::vector<std::string> all = spellings(uri);
  return std::any_of(all.begin(), all.end(), [&](const std::string& spelling) {
    return candidates(spelling, folder).lead_out;
  });
}

std::optional<std::string> ResourceFinder::unknownPackage(const std::string& uri) const {
  const Uri parts = parse(uri);
  const std::string package = splitName(parts.rest).first;
  const bool is_asked_for = parts.scheme == "package" && package_finder_ && !package.empty();
  if (!is_asked_for || package_finder_(package)) return std::nullopt;
  return package;
}

std::string ResourceFinder::nearMiss(const std::string& uri, const fs::path& folder) const {
  for (const fs::path& path : candidates(uri, folder).paths) {
    const std::string near = base::didYouMeanFile(path);
    if (!near.empty()) return near;
  }
  return "";
}

std::string ResourceFinder::searchedPlaces(const std::string& uri, const fs::path& folder) const {
  if (leadsOut(uri, folder)) {
    return "it leads out of the folders that it may name, and nothing outside of them is read";
  }
  std::vector<std::string> places;
  std::set<std::string> exported;  // not chosen by the reader: their number is enough
  for (const std::string& spelling : spellings(uri)) {
    for (const std::string& place : candidates(spelling, folder).shown) {
      if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
    }
    for (const std::string& place : exportedCandidates(spelling).shown) exported.insert(place);
  }
  for (const std::string& place : places) exported.erase(place);
  if (!exported.empty()) {
    places.push_back(std::to_string(exported.size()) +
                     (exported.size() == 1 ? " folder" : " folders") +
                     " that ROS packages export for Gazebo");
  }
  std::string text;
  for (const std::string& place : places) text += (text.empty() ? "looked in " : ", ") + place;
  const auto add = [&](const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
  if (const auto package = unknownPackage(uri)) {
    add("ROS knows no package '" + *package + "' (is the setup.bash of its workspace sourced?)" +
        base::didYouMeanPackage(*package));
  }
  if (isOf(uri, {"http", "https", "fuel"})) add("nothing is fetched from the network");
  text += nearMiss(uri, folder);
  if (!text.empty()) return text;
  return "known are model://, package://, file://, https:// of Gazebo's model server, absolute and "
         "relative paths";
}

}  // namespace synthetic_dataset::world
