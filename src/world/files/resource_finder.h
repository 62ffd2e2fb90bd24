#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace synthetic_dataset::world {

/// Finds the files that worlds and models name by URI. The network is never asked.
///
/// - `model://name/rest`: in the folders given here, then those of GAZEBO_MODEL_PATH,
///   GZ_SIM_RESOURCE_PATH, IGN_GAZEBO_RESOURCE_PATH and SDF_PATH, in this order, then in
///   ~/.gazebo/models, where Gazebo keeps what it has downloaded, then in the ROS package `name`
///   (libsdformat rewrites the `package://` of URDF files to `model://`), then, where the naming
///   file lies in a model of this name, in that;
/// - `package://name/rest`: in the ROS package, then as `model://`;
/// - `https://fuel.gazebosim.org/1.0/owner/models/name` and the like: in the caches of Gazebo's
///   tools (see fuel.h);
/// - `file://path` and absolute paths: as they are;
/// - anything else: relative to the folder of the file that names it.
///
/// What is not found as it stands is tried with its percent escapes decoded, and with the
/// backslashes of Windows as slashes.
class ResourceFinder {
 public:
  /// Gives the folder of a ROS package, or nothing.
  using PackageFinder = std::function<std::optional<std::string>(const std::string& package)>;

  /// @param model_folders  folders that hold models, looked into before the environment's
  ResourceFinder(std::vector<std::string> model_folders, PackageFinder package_finder);

  /// The file (or folder) that `uri` means in a file of `folder`, or nothing where there is none.
  [[nodiscard]] std::optional<std::filesystem::path> find(
      const std::string& uri, const std::filesystem::path& folder) const;

  /// The files that were found so far.
  [[nodiscard]] const std::set<std::filesystem::path>& found() const { return found_; }

  /// Where `find` looks for the URI, for messages: "looked in a, b, c".
  [[nodiscard]] std::string searchedPlaces(const std::string& uri,
                                           const std::filesystem::path& folder) const;

 private:
  /// The places that a URI may mean, the first to be tried first.
  [[nodiscard]] std::vector<std::filesystem::path> candidates(
      const std::string& uri, const std::filesystem::path& folder) const;
  /// Those of a URI as it stands.
  [[nodiscard]] std::vector<std::filesystem::path> literalCandidates(
      const std::string& uri, const std::filesystem::path& folder) const;
  [[nodiscard]] std::vector<std::filesystem::path> inModelFolders(const std::string& rest) const;
  [[nodiscard]] std::vector<std::filesystem::path> inPackage(const std::string& rest) const;

  /// The package that a URI names, if ROS does not know it.
  [[nodiscard]] std::optional<std::string> unknownPackage(const std::string& uri) const;

  std::vector<std::string> model_folders_;
  std::vector<std::filesystem::path> fuel_caches_;
  PackageFinder package_finder_;
  mutable std::set<std::filesystem::path> found_;  ///< a memory that changes no answer
};

}  // namespace synthetic_dataset::world
