#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace synthetic_dataset::world {

/// Whether a path lies in a folder, or is it, by its names alone: `..` is resolved, links are not.
[[nodiscard]] bool isWithin(const std::filesystem::path& path, const std::filesystem::path& folder);

/// Folders that ROS packages export for Gazebo in their package.xml:
/// `<export><gazebo_ros gazebo_model_path="..." gazebo_media_path="..."/></export>`.
struct ExportedFolders {
  std::vector<std::string> models;  ///< as those of GAZEBO_MODEL_PATH
  std::vector<std::string> media;   ///< as those of GAZEBO_RESOURCE_PATH
};

/// Finds the files that worlds and models name by URI, as Gazebo's SystemPaths and sdformat's
/// findFile do. The network is never asked.
///
/// - `model://name/rest`: in the folders given here, then those of GAZEBO_MODEL_PATH,
///   GZ_SIM_RESOURCE_PATH, IGN_GAZEBO_RESOURCE_PATH and SDF_PATH, in this order, then in
///   ~/.gazebo/models, where Gazebo keeps what it has downloaded, and in the models of an installed
///   Gazebo, then in the ROS package `name` (libsdformat rewrites the `package://` of URDF files to
///   `model://`), then, where the naming file lies in a model of this name, in that;
/// - `package://name/rest`: in the ROS package, then as `model://`;
/// - `https://fuel.gazebosim.org/1.0/owner/models/name` and the like: in the caches of Gazebo's
///   tools (see fuel.h);
/// - `file://path`, paths and names: relative to the folder of the file that names them; then in
///   the folders of GAZEBO_RESOURCE_PATH and of an installed Gazebo, each also below `models/`,
///   `media/models/` and `Media/models/`; then in the folders that models are looked for in;
/// - absolute paths: as they are.
///
/// What is not found so is looked for in the folders that ROS packages export. Each spelling is
/// tried as it stands, then with its percent escapes decoded, then with the backslashes of Windows
/// as slashes.
///
/// `..` never leads out of a folder that is searched: `model://name/../../file` is refused
/// (`leadsOut`). A package's neighbours may be named: `package://name/../other/file`.
class ResourceFinder {
 public:
  /// Gives the folder of a ROS package, or nothing.
  using PackageFinder = std::function<std::optional<std::string>(const std::string& package)>;

  /// Gives what ROS packages export. Called when something is not found otherwise.
  using ExportFinder = std::function<ExportedFolders()>;

  /// @param model_folders  folders that hold models, looked into before the environment's
  ResourceFinder(std::vector<std::string> model_folders, PackageFinder package_finder,
                 ExportFinder export_finder = nullptr);

  /// The file (or folder) that `uri` means in a file of `folder`, or nothing where there is none.
  [[nodiscard]] std::optional<std::filesystem::path> find(
      const std::string& uri, const std::filesystem::path& folder) const;

  /// A file at a path that is known, as `find` would give it.
  [[nodiscard]] std::optional<std::filesystem::path> at(const std::filesystem::path& path) const;

  /// The folders of GAZEBO_RESOURCE_PATH and of an installed Gazebo, and those that ROS packages
  /// export as Gazebo's media.
  [[nodiscard]] std::vector<std::string> mediaFolders() const;

  /// The files that were found so far.
  [[nodiscard]] const std::set<std::filesystem::path>& found() const { return found_; }

  /// Where something was looked for so far and nothing was.
  [[nodiscard]] const std::set<std::filesystem::path>& missed() const { return missed_; }

  /// The URIs that were found nowhere so far.
  [[nodiscard]] const std::set<std::string>& unresolved() const { return unresolved_; }

  /// Where `find` looks for the URI, for messages: "looked in a, b, c".
  [[nodiscard]] std::string searchedPlaces(const std::string& uri,
                                           const std::filesystem::path& folder) const;

  /// Whether a URI would lead out of the folders that it may name; `find` has nothing for it then.
  [[nodiscard]] bool leadsOut(const std::string& uri, const std::filesystem::path& folder) const;

  /// Keeps that a file names another that it may not name. There is no dataset of such a world,
  /// even where files may be missing.
  void refuse(const std::string& message) const { refusals_.insert(message); }

  /// What was asked for so far that leads out of the folders that it may name, and what was
  /// refused.
  [[nodiscard]] const std::set<std::string>& refusals() const { return refusals_; }

 private:
  /// "; did you mean 'x'?" of the files beside those that a URI may mean, or nothing.
  [[nodiscard]] std::string nearMiss(const std::string& uri,
                                     const std::filesystem::path& folder) const;

  struct Candidates;

  /// The candidates for a URI as it stands.
  [[nodiscard]] Candidates candidates(const std::string& uri,
                                      const std::filesystem::path& folder) const;
  /// Candidates in exported folders, which are searched last.
  [[nodiscard]] Candidates exportedCandidates(const std::string& uri) const;

  static void addModel(const std::string& rest, const std::vector<std::string>& folders,
                       Candidates& to);
  void addPackage(const std::string& rest, Candidates& to) const;
  static void addPlain(const std::string& rest, const std::vector<std::string>& media,
                       const std::vector<std::string>& models, Candidates& to);

  /// The package that a URI names, if ROS does not know it.
  [[nodiscard]] std::optional<std::string> unknownPackage(const std::string& uri) const;

  std::vector<std::string> model_folders_;
  std::vector<std::string> media_folders_;
  std::vector<std::filesystem::path> fuel_caches_;
  PackageFinder package_finder_;
  ExportFinder export_finder_;
  mutable std::set<std::filesystem::path> found_;   ///< a memory that changes no answer
  mutable std::set<std::filesystem::path> missed_;  ///< another
  mutable std::set<std::string> unresolved_;        ///< another
  mutable std::set<std::string> refusals_;          ///< another
};

}  // namespace synthetic_dataset::world
