#include "world/files/resource_finder.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <sstream>
#include <system_error>
#include <utility>

#include "world/files/fuel.h"
#include "world/files/text.h"

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolderVariables[] = {"GAZEBO_MODEL_PATH", "GZ_SIM_RESOURCE_PATH",
                                            "IGN_GAZEBO_RESOURCE_PATH", "SDF_PATH"};

/// A URI in its two parts; a plain path has no scheme.
struct Uri {
  std::string scheme;
  std::string rest;
};

Uri parse(const std::string& text) {
  const std::size_t end = text.find("://");
  if (end == std::string::npos) return {"", text};
  return {text.substr(0, end), text.substr(end + 3)};
}

void appendFoldersOf(const char* variable, std::vector<std::string>& folders) {
  const char* value = std::getenv(variable);
  if (value == nullptr) return;
  std::istringstream list(value);
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) folders.push_back(folder);
  }
}

void append(std::vector<fs::path>& to, std::vector<fs::path> from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// Absolute, and without `.`, `..` or a slash at the end, so that messages read well.
fs::path tidy(const fs::path& path) {
  fs::path result = fs::absolute(path).lexically_normal();
  return result.has_filename() ? result : result.parent_path();
}

/// A model's name as folders have it: "Ground Plane" is "ground_plane".
std::string folderName(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
    return c == ' ' ? '_' : static_cast<char>(std::tolower(c));
  });
  return name;
}

/// In the model that `folder` is part of, if that has the name: files of a model in Fuel's cache,
/// whose folder is called by its version, name their meshes `model://name/...`.
std::vector<fs::path> inOwnModel(const std::string& rest, const fs::path& folder) {
  const std::size_t end = rest.find('/');
  const std::string name = folderName(rest.substr(0, end));
  for (fs::path model = folder; model.has_relative_path(); model = model.parent_path()) {
    std::error_code ignored;
    if (!fs::exists(model / "model.config", ignored)) continue;
    const bool same = folderName(model.filename().string()) == name ||
                      folderName(model.parent_path().filename().string()) == name;
    if (!same) return {};
    return {end == std::string::npos ? model : tidy(fs::path(model.string() + rest.substr(end)))};
  }
  return {};
}

}  // namespace

ResourceFinder::ResourceFinder(std::vector<std::string> model_folders, PackageFinder package_finder)
    : model_folders_(std::move(model_folders)),
      fuel_caches_(fuelCaches()),
      package_finder_(std::move(package_finder)) {
  for (const char* variable : kFolderVariables) appendFoldersOf(variable, model_folders_);
  if (const char* home = std::getenv("HOME")) {
    model_folders_.push_back(std::string(home) + "/.gazebo/models");
  }
}

std::vector<fs::path> ResourceFinder::inModelFolders(const std::string& rest) const {
  std::vector<fs::path> places;
  for (const std::string& folder : model_folders_) {
    places.push_back(tidy(fs::path(folder) / fs::path(rest).relative_path()));
  }
  return places;
}

std::vector<fs::path> ResourceFinder::inPackage(const std::string& rest) const {
  const std::size_t end = rest.find('/');
  const std::string package = rest.substr(0, end);
  if (!package_finder_ || package.empty()) return {};
  const std::optional<std::string> folder = package_finder_(package);
  if (!folder) return {};
  return {end == std::string::npos ? tidy(*folder) : tidy(fs::path(*folder + rest.substr(end)))};
}

std::optional<std::string> ResourceFinder::unknownPackage(const std::string& uri) const {
  const Uri parts = parse(uri);
  const std::string package = parts.rest.substr(0, parts.rest.find('/'));
  const bool is_asked_for = parts.scheme == "package" && package_finder_ && !package.empty();
  if (!is_asked_for || package_finder_(package)) return std::nullopt;
  return package;
}

std::vector<fs::path> ResourceFinder::literalCandidates(const std::string& uri,
                                                        const fs::path& folder) const {
  const Uri parts = parse(uri);
  if (parts.rest.empty() || uri.find('\0') != std::string::npos) return {};
  std::vector<fs::path> places;
  if (parts.scheme == "model") {
    append(places, inModelFolders(parts.rest));
    append(places, inPackage(parts.rest));
    append(places, inOwnModel(parts.rest, folder));
  } else if (parts.scheme == "package") {
    append(places, inPackage(parts.rest));
    append(places, inModelFolders(parts.rest));
  } else if (parts.scheme.empty() || parts.scheme == "file") {
    places.push_back(tidy(folder / parts.rest));  // an absolute `rest` replaces the folder
  } else if (const auto fuel = parseFuelUri(uri)) {
    append(places, fuelPlaces(*fuel, fuel_caches_));
  }
  return places;
}

std::vector<fs::path> ResourceFinder::candidates(const std::string& uri,
                                                 const fs::path& folder) const {
  std::vector<fs::path> places = literalCandidates(uri, folder);
  for (const std::string& other : {percentDecoded(uri), withSlashes(uri)}) {
    if (other != uri) append(places, literalCandidates(other, folder));
  }
  return places;
}

std::optional<fs::path> ResourceFinder::find(const std::string& uri, const fs::path& folder) const {
  for (const fs::path& place : candidates(uri, folder)) {
    std::error_code ignored;  // neither of what is not there nor of a device, which may never end
    const fs::file_status status = fs::status(place, ignored);
    if (fs::is_regular_file(status)) found_.insert(place);
    if (fs::is_regular_file(status) || fs::is_directory(status)) return place;
  }
  return std::nullopt;
}

std::string ResourceFinder::searchedPlaces(const std::string& uri, const fs::path& folder) const {
  const std::string scheme = parse(uri).scheme;
  const bool remote = scheme == "http" || scheme == "https" || scheme == "fuel";
  std::string text;
  for (const fs::path& place : candidates(uri, folder)) {
    text += (text.empty() ? "looked in " : ", ") + place.string();
  }
  if (const auto package = unknownPackage(uri)) {
    text += (text.empty() ? "" : "; ") + ("ROS knows no package '" + *package) +
            "' (is the setup.bash of its workspace sourced?)";
  }
  if (remote) text += std::string(text.empty() ? "" : "; ") + "nothing is fetched from the network";
  if (!text.empty()) return text;
  return "known are model://, package://, file://, https:// of Gazebo's model server, absolute and "
         "relative paths";
}

}  // namespace synthetic_dataset::world
